package io.github.sofas.cli;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;

/**
 * Checks the files that a command is about to write, before anything is run. No output may replace an input, another
 * output or, unless the user forces it, an existing file.
 */
final class OutputFiles {
    private final CommandLine command;

    OutputFiles(CommandLine command) {
        this.command = command;
    }

    /**
     * Creates the folder of the results if it does not exist.
     *
     * @throws ParameterException if the name cannot be that of a folder
     * @throws FailureException if the system does not allow us to create it
     */
    void makeFolder(Path folder) {
        if (folder.toString().isEmpty()) {
            throw new ParameterException(command, "--out must name a directory but was empty");
        }
        try {
            Files.createDirectories(folder);
        } catch (AccessDeniedException e) {
            throw new FailureException("[" + folder + "] cannot be made a directory: " + FileFailure.text(e), e);
        } catch (IOException e) {
            throw new ParameterException(command, "[" + folder + "] cannot be made a directory: "
                + FileFailure.text(e), e);
        }
    }

    /**
     * Checks that no output overwrites an input and none is written twice. Links are followed.
     *
     * @param inputs and outputs may hold null for files that were not asked for
     * @throws ParameterException if one would
     */
    void check(List<Path> inputs, List<Path> outputs) {
        List<Path> written = new ArrayList<>();
        for (Path output : outputs) {
            if (output == null) {
                continue;
            }
            for (Path input : inputs) {
                if (input != null && isSame(input, output)) {
                    throw new ParameterException(command, "[" + output + "] is read and cannot be written"
                        + (input.equals(output) ? "" : ": it is " + input));
                }
            }
            for (Path other : written) {
                if (isSame(other, output)) {
                    throw new ParameterException(command, "[" + output + "] cannot be written twice"
                        + (other.equals(output) ? "" : ": it is " + other));
                }
            }
            written.add(output);
        }
    }

    /**
     * Checks that outputs can be written at their places. A command that creates folders does so before.
     *
     * @param outputs may hold null for files that were not asked for
     * @throws ParameterException if the folder of an output is missing, or a folder is in the place of the output
     */
    void checkPlaces(List<Path> outputs) {
        for (Path output : outputs) {
            if (output != null && Files.isDirectory(output)) {
                throw new ParameterException(command, "[" + output + "] is a directory and cannot be written");
            }
            Path parent = output == null ? null : output.getParent();
            if (parent != null && !Files.isDirectory(parent)) {
                throw new ParameterException(command, "[" + output + "] cannot be written: there is no directory "
                    + parent);
            }
        }
    }

    /**
     * Checks that no output exists.
     *
     * @throws ParameterException if one does
     */
    void refuseExisting(List<Path> outputs) {
        outputs.stream().filter(Objects::nonNull).filter(OutputFiles::isThere).findFirst().ifPresent(existing -> {
            throw new ParameterException(command, "[" + existing + "] exists already; --force replaces it");
        });
    }

    /** Whether something of this name exists, even a link that leads nowhere. */
    static boolean isThere(Path file) {
        return Files.exists(file, LinkOption.NOFOLLOW_LINKS);
    }

    private static boolean isSame(Path a, Path b) {
        try {
            return real(a).equals(real(b)) || Files.exists(a) && Files.exists(b) && Files.isSameFile(a, b);
        } catch (IOException e) {
            return false;
        }
    }

    /** Real path of a file that exists or will be written. */
    private static Path real(Path file) throws IOException {
        if (Files.exists(file)) {
            return file.toRealPath();
        }
        Path absolute = file.toAbsolutePath().normalize();
        Path folder = absolute.getParent();
        return folder == null || !Files.exists(folder) ? absolute : folder.toRealPath().resolve(absolute.getFileName());
    }
}
