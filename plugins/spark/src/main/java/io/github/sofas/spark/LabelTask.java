package io.github.sofas.spark;

import io.github.sofas.batch.BatchColumn;
import io.github.sofas.batch.BatchOrder;
import io.github.sofas.batch.BatchRow;
import io.github.sofas.batch.BatchTask;
import java.io.Serializable;
import java.time.Instant;
import org.apache.spark.SparkEnv;
import org.apache.spark.TaskContext;
import org.apache.spark.TaskKilledException;
import scala.collection.Iterator;
import scala.runtime.AbstractFunction2;

/**
 * The function that an executor applies to the one recording of a partition: it has the program label the recording,
 * and returns the row with the facts about the task.
 */
final class LabelTask extends AbstractFunction2<TaskContext, Iterator<BatchTask>, BatchRow> implements Serializable {
    private static final long serialVersionUID = 1L;

    private final BatchOrder order;
    private final ShownName recordingName;
    private final int mostAttempts;

    /**
     * Makes the function.
     *
     * @param recordingName shows in Spark's UI which recording a task labels
     * @param mostAttempts number of attempts after which a recording is given up, if each attempt died with its
     *     process: after too many of them, Spark would give up the whole batch
     */
    LabelTask(BatchOrder order, ShownName recordingName, int mostAttempts) {
        this.order = order;
        this.recordingName = recordingName;
        this.mostAttempts = mostAttempts;
    }

    @Override
    public BatchRow apply(TaskContext context, Iterator<BatchTask> tasks) {
        BatchTask task = tasks.next();
        recordingName.add(task.name());
        Instant started = Instant.now();
        long startNs = System.nanoTime();
        BatchRow row;
        try {
            row = context.attemptNumber() < mostAttempts ? label(task)
                : new BatchRow(task).failed("[" + task.recording().name() + "] its task died "
                    + context.attemptNumber() + " times, the process with it; the executor's log may tell why");
        } catch (InterruptedException e) {
            throw new TaskKilledException(e.getMessage());
        }
        return row.set(BatchColumn.TASK_STARTED, started)
            .set(BatchColumn.TASK_S, (System.nanoTime() - startNs) / 1e9)
            .set(BatchColumn.TASK_ATTEMPT, (long) context.attemptNumber())
            .set(BatchColumn.HOST, SparkEnv.get().blockManager().blockManagerId().host());
    }

    private BatchRow label(BatchTask task) throws InterruptedException {
        RunningTasks.HERE.begin();
        try {
            return IsolatedProgram.get().label(order, task, new HadoopStorage(SparkEnv.get().conf()));
        } finally {
            RunningTasks.HERE.end();
        }
    }
}
