package io.github.sofas.cli;

import io.github.sofas.batch.BatchOrder;
import io.github.sofas.batch.BatchProgram;
import io.github.sofas.batch.BatchRow;
import io.github.sofas.batch.BatchTask;
import io.github.sofas.batch.Cluster;
import io.github.sofas.batch.Storage;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.util.ArrayList;
import java.util.List;

/**
 * The program as a cluster calls it: on the machine where a batch is submitted, and on those where recordings are
 * labelled. Public because Java's service loader requires that.
 */
public final class Batches implements BatchProgram {
    @Override
    public int submit(List<String> arguments, Cluster cluster) {
        List<String> all = new ArrayList<>(List.of("batch"));
        all.addAll(arguments);
        Charset charset = Charset.defaultCharset();
        return Main.execute(cluster, new PrintWriter(System.out, true, charset),
            new PrintWriter(System.err, true, charset), all.toArray(String[]::new));
    }

    @Override
    public BatchRow label(BatchOrder order, BatchTask task, Storage storage) throws InterruptedException {
        return new BatchLabelling(order, task, storage).label();
    }
}
