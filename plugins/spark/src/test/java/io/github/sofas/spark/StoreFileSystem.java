package io.github.sofas.spark;

import java.net.URI;
import org.apache.hadoop.fs.RawLocalFileSystem;

/** A disk that only Hadoop can read: {@code store:///path}. */
public final class StoreFileSystem extends RawLocalFileSystem {
    @Override
    public URI getUri() {
        return URI.create("store:///");
    }

    @Override
    public String getScheme() {
        return "store";
    }
}
