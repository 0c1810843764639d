package io.github.sofas.spark;

import io.github.sofas.batch.BatchOrder;
import io.github.sofas.batch.BatchRow;
import io.github.sofas.batch.BatchTask;
import io.github.sofas.batch.Cluster;
import io.github.sofas.batch.Storage;
import io.github.sofas.batch.StoredFile;
import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.apache.hadoop.fs.FileSystem;
import org.apache.hadoop.util.ShutdownHookManager;
import org.apache.spark.SparkConf;
import org.apache.spark.SparkContext;
import org.apache.spark.SparkException;
import org.apache.spark.api.java.JavaSparkContext;
import scala.collection.immutable.Seq;
import scala.jdk.javaapi.CollectionConverters;
import scala.reflect.ClassTag$;
import scala.runtime.AbstractFunction2;
import scala.runtime.BoxedUnit;

/**
 * A Spark application that labels recordings: one job, with one task per recording. It lives in the driver; {@link
 * LabelTask} runs on the executors.
 */
final class SparkCluster implements Cluster {
    /** A scheme has more than one letter: one letter is a drive. */
    private static final Pattern SCHEME = Pattern.compile("[A-Za-z][A-Za-z0-9+.-]+:/.*", Pattern.DOTALL);
    /** Spark's own default of spark.task.maxFailures, for masters that repeat failed tasks at all. */
    private static final int MOST_FAILURES = 4;
    private static final String LOOPBACK = "127.0.0.1";
    /**
     * Priority of the hook that waits for the end of the batch. Spark ends its tasks before this hook, and Hadoop
     * closes its file systems after it.
     */
    private static final int AFTER_SPARK = FileSystem.SHUTDOWN_HOOK_PRIORITY + 10;
    private static final int ENDING_S = 20;
    /** Part of these {@value #ENDING_S} s that tasks in this process get to end. */
    private static final int TASKS_END_S = 5;

    private final SparkConf conf = new SparkConf();
    private final HadoopStorage storage = new HadoopStorage(conf);
    private final CountDownLatch over = new CountDownLatch(1);
    private SparkContext context;

    @Override
    public String qualified(String place) throws IOException {
        if (SCHEME.matcher(place).matches()) {
            return place.startsWith("file:") ? Path.of(URI.create(place).getPath()).normalize().toString()
                : storage.qualified(place);
        }
        return storage.isLocalByDefault() ? Path.of(place).toAbsolutePath().normalize().toString()
            : storage.qualified(place);
    }

    @Override
    public List<StoredFile> find(String pattern) throws IOException {
        return storage.find(pattern);
    }

    @Override
    public Storage storage() {
        return storage;
    }

    @Override
    public String start(String master) throws IOException {
        if (master != null) {
            conf.setMaster(master);
        }
        conf.setIfMissing("spark.master", "local[*]");
        conf.setIfMissing("spark.app.name", "SOFAS");
        conf.setIfMissing("spark.ui.showConsoleProgress", "false");
        // A slow task has a long recording, not a slow machine; two tasks must not write the same results.
        conf.set("spark.speculation", "false");
        boolean isHere = conf.get("spark.master").startsWith("local");
        if (isHere) {
            // no other machine has to reach the driver
            conf.setIfMissing("spark.driver.bindAddress", LOOPBACK);
            conf.setIfMissing("spark.driver.host", LOOPBACK);
        } else {
            conf.setIfMissing("spark.jars", SparkContext.jarOfClass(SparkCluster.class).get());
        }
        try {
            context = new SparkContext(conf);
        } catch (RuntimeException e) {
            throw new IOException("Spark does not start: " + e.getMessage(), e);
        }
        // The process must not end before unfinished files are deleted.
        ShutdownHookManager.get().addShutdownHook(this::awaitEnd, AFTER_SPARK, ENDING_S, TimeUnit.SECONDS);
        return "Spark " + context.version() + ", " + context.master()
            + (context.uiWebUrl().isEmpty() ? "" : ", " + context.uiWebUrl().get());
    }

    private void awaitEnd() {
        try {
            over.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Receives each row on the driver. */
    private static final class Ended extends AbstractFunction2<Object, BatchRow, BoxedUnit> {
        private final Consumer<BatchRow> receiver;

        Ended(Consumer<BatchRow> receiver) {
            this.receiver = receiver;
        }

        @Override
        public BoxedUnit apply(Object partition, BatchRow row) {
            receiver.accept(row);
            return BoxedUnit.UNIT;
        }
    }

    @Override
    public void label(BatchOrder order, List<BatchTask> tasks, Consumer<BatchRow> ended) throws IOException {
        ShownName name = new ShownName();
        context.register(name, "recording");
        LabelTask labelling = new LabelTask(order, name,
            Math.max(1, conf.getInt("spark.task.maxFailures", MOST_FAILURES) - 1));
        context.setJobDescription(tasks.size() + " recordings to " + order.out());
        Seq<Object> all = CollectionConverters.asScala(
            IntStream.range(0, tasks.size()).<Object>mapToObj(Integer::valueOf).toList()).toSeq();
        try {
            context.runJob(JavaSparkContext.fromSparkContext(context).parallelize(tasks, tasks.size()).rdd(), labelling,
                all, new Ended(ended), ClassTag$.MODULE$.apply(BatchRow.class));
        } catch (Exception e) {
            RunningTasks.HERE.stop(TASKS_END_S);
            // Scala throws this checked exception without declaring it
            if (e instanceof SparkException) {
                throw new IOException(e.getMessage().lines().findFirst().orElse(""), e);
            }
            throw e;
        }
    }

    @Override
    public void writeTable(List<BatchRow> rows, Path file) throws IOException {
        RowTable.write(rows, file);
    }

    @Override
    public void close() {
        over.countDown();
        if (context != null) {
            context.stop();
        }
    }
}
