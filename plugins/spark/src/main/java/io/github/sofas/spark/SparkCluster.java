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

/** A Spark application that labels recordings: one job, with one task a recording. */
final class SparkCluster implements Cluster {
    /** More than one letter, which would be a drive. */
    private static final Pattern SCHEME = Pattern.compile("[A-Za-z][A-Za-z0-9+.-]+:/.*", Pattern.DOTALL);
    /** Spark's own, of masters that try again at all. */
    private static final int MOST_FAILURES = 4;
    private static final String LOOPBACK = "127.0.0.1";
    /** After Spark has ended its tasks, before Hadoop closes its file systems. */
    private static final int AFTER_SPARK = FileSystem.SHUTDOWN_HOOK_PRIORITY + 10;
    private static final int ENDING_S = 20;
    /** Of which tasks that run in this process get so much. */
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
        // A recording that takes long is long, and two that write the same results would be one too many.
        conf.set("spark.speculation", "false");
        boolean isHere = conf.get("spark.master").startsWith("local");
        if (isHere) {
            // nobody else has to reach it
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
        // The end of the process waits until what is not whole is deleted.
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

    /** Gets each row on the driver. */
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
            // not declared, Scala throws it all the same
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
