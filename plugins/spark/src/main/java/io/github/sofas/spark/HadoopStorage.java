package io.github.sofas.spark;

import io.github.sofas.batch.Storage;
import io.github.sofas.batch.StoredFile;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.UUID;
import org.apache.hadoop.conf.Configuration;
import org.apache.hadoop.fs.FileStatus;
import org.apache.hadoop.fs.FileSystem;
import org.apache.hadoop.fs.Path;
import org.apache.spark.SparkConf;
import org.apache.spark.deploy.SparkHadoopUtil;

/**
 * Access to files on any file system that Hadoop opens, such as HDFS or S3. Both the driver and the executors use it
 * for places that are not on their machine.
 */
final class HadoopStorage implements Storage {
    private final Configuration configuration;

    /** Uses Hadoop's settings, and the settings of Spark that are meant for Hadoop ({@code spark.hadoop.*}). */
    HadoopStorage(SparkConf conf) {
        configuration = SparkHadoopUtil.get().newConfiguration(conf);
    }

    private FileSystem system(Path path) throws IOException {
        return path.getFileSystem(configuration);
    }

    /** Whether places without a scheme are on this machine. */
    boolean isLocalByDefault() {
        return "file".equals(FileSystem.getDefaultUri(configuration).getScheme());
    }

    /** The place as a complete URI. */
    String qualified(String place) throws IOException {
        try {
            Path path = new Path(place);
            return system(path).makeQualified(path).toString();
        } catch (IllegalArgumentException e) {
            throw new IOException("[" + place + "] is no place: " + e.getMessage(), e);
        }
    }

    /** The files that a place or a pattern names, without hidden ones, in the order of their places. */
    List<StoredFile> find(String pattern) throws IOException {
        Path path = new Path(pattern);
        FileSystem system = system(path);
        FileStatus[] matches = system.globStatus(path);
        List<StoredFile> files = new ArrayList<>();
        for (FileStatus match : matches == null ? new FileStatus[0] : matches) {
            boolean isFolder = match.isDirectory() && matches.length == 1;
            for (FileStatus each : isFolder ? system.listStatus(match.getPath()) : new FileStatus[] {match}) {
                String name = each.getPath().getName();
                if (each.isFile() && !name.startsWith(".")) {
                    String place = each.getPath().toString();
                    files.add(new StoredFile(place, place, each.getLen(), each.getModificationTime()));
                }
            }
        }
        return files;
    }

    @Override
    public Set<String> names(String folder) throws IOException {
        Path path = new Path(folder);
        Set<String> names = new TreeSet<>();
        try {
            for (FileStatus each : system(path).listStatus(path)) {
                names.add(each.getPath().getName());
            }
        } catch (FileNotFoundException e) {
            return Set.of();
        }
        return names;
    }

    @Override
    public long bytes(String file) throws IOException {
        Path path = new Path(file);
        try {
            return system(path).getFileStatus(path).getLen();
        } catch (FileNotFoundException e) {
            return -1;
        }
    }

    @Override
    public void fetch(String file, java.nio.file.Path local, long mostBytes) throws IOException {
        Path path = new Path(file);
        try (InputStream in = system(path).open(path)) {
            Storage.copy(in, local, mostBytes);
        }
    }

    @Override
    public void put(java.nio.file.Path local, String file, String staging) throws IOException {
        Path target = new Path(file);
        FileSystem system = system(target);
        String unique = UUID.randomUUID().toString();
        Path stage = new Path(staging);
        // files can be renamed only within one file system
        Path part = system.equals(system(stage)) ? new Path(stage, unique)
            : new Path(target.getParent(), "." + unique + ".part");
        try {
            system.mkdirs(part.getParent());
            try (OutputStream out = system.create(part, true)) {
                Files.copy(local, out);
            }
            system.mkdirs(target.getParent());
            system.delete(target, false);
            if (!system.rename(part, target)) {
                throw new IOException(file + " cannot be given its name");
            }
        } catch (IOException | RuntimeException e) {
            system.delete(part, false);
            throw e;
        }
        Files.delete(local);
    }

    @Override
    public void delete(String place) throws IOException {
        Path path = new Path(place);
        system(path).delete(path, true);
    }
}
