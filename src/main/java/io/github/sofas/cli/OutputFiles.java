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

/** What a command is about to write, looked at before anything is run. */
final class OutputFiles {
    private final CommandLine command;

    OutputFiles(CommandLine command) {
        this.command = command;
    }

    /**
     * Makes the folder of the results where it is not there.
     *
     * @throws ParameterException where the name cannot be that of a folder
     * @throws FailureException where the system does not let us make it
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
     * Checks that nothing is written over what is read, or twice; links lead where they lead.
     *
     * @param inputs and outputs may hold null for what was not asked for
     * @throws ParameterException where something would be
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
     * Checks that files can be where they are to be, for a command that makes no folder.
     *
     * @param outputs may hold null for what was not asked for
     * @throws ParameterException where a folder is not there, or one is in place of the file
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
     * @throws ParameterException where one does
     */
    void refuseExisting(List<Path> outputs) {
        outputs.stream().filter(Objects::nonNull).filter(OutputFiles::isThere).findFirst().ifPresent(existing -> {
            throw new ParameterException(command, "[" + existing + "] exists already; --force replaces it");
        });
    }

    /** Whether there is something of this name, be it a link that leads nowhere. */
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

    /** Where a file is or will be. */
    private static Path real(Path file) throws IOException {
        if (Files.exists(file)) {
            return file.toRealPath();
        }
        Path absolute = file.toAbsolutePath().normalize();
        Path folder = absolute.getParent();
        return folder == null || !Files.exists(folder) ? absolute : folder.toRealPath().resolve(absolute.getFileName());
    }
}
