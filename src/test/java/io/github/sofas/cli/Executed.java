package io.github.sofas.cli;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;

/** One command that was run, and all that the user saw of it. */
final class Executed {
    final int exitCode;
    final String out;
    final String err;

    private Executed(int exitCode, String out, String err) {
        this.exitCode = exitCode;
        this.out = out;
        this.err = err;
    }

    /** Runs a command in this process. */
    static Executed command(String... arguments) {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        int exitCode = Main.execute(new PrintWriter(out), new PrintWriter(err), arguments);
        return new Executed(exitCode, out.toString(), err.toString());
    }

    /** The lines on standard error. */
    List<String> errLines() {
        return err.lines().toList();
    }
}
