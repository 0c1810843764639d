package io.github.sofas.cli;

import io.github.sofas.batch.Storage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;

/**
 * Storage on the disks of this machine and on file systems that are mounted on it. Files get their places by renaming,
 * so that no program sees a part of one.
 */
final class LocalStorage implements Storage {
    @Override
    public Set<String> names(String folder) {
        String[] names = Path.of(folder).toFile().list();
        return names == null ? Set.of() : new TreeSet<>(Arrays.asList(names));
    }

    @Override
    public long bytes(String file) throws IOException {
        try {
            return Files.size(Path.of(file));
        } catch (NoSuchFileException e) {
            return -1;
        }
    }

    @Override
    public void fetch(String file, Path local, long mostBytes) throws IOException {
        try (InputStream in = Files.newInputStream(Path.of(file))) {
            Storage.copy(in, local, mostBytes);
        }
        Files.setLastModifiedTime(local, Files.getLastModifiedTime(Path.of(file)));
    }

    @Override
    public void put(Path local, String file, String staging) throws IOException {
        Path target = Path.of(file);
        Files.createDirectories(target.getParent());
        try {
            Files.move(local, target, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            // on another disk: copied under a hidden name first, then renamed
            Path hidden = Files.createTempFile(target.getParent(), ".", ".part");
            try {
                Files.copy(local, hidden, StandardCopyOption.REPLACE_EXISTING);
                Files.move(hidden, target, StandardCopyOption.ATOMIC_MOVE);
            } finally {
                Files.deleteIfExists(hidden);
            }
        }
    }

    @Override
    public void delete(String place) throws IOException {
        Path path = Path.of(place);
        if (!Files.exists(path)) {
            return;
        }
        Files.walkFileTree(path, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
                Files.deleteIfExists(file);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFileFailed(Path file, IOException failure) throws IOException {
                // already gone: it was still being written when it was found
                if (failure instanceof NoSuchFileException) {
                    return FileVisitResult.CONTINUE;
                }
                throw failure;
            }

            @Override
            public FileVisitResult postVisitDirectory(Path folder, IOException failure) throws IOException {
                Files.deleteIfExists(folder);
                return FileVisitResult.CONTINUE;
            }
        });
    }
}
