package io.github.sofas.spark;

import org.apache.spark.util.AccumulatorV2;

/**
 * An accumulator of Spark that holds a name. Spark's UI shows the name in the row of each task; the driver keeps only
 * the last one.
 */
final class ShownName extends AccumulatorV2<String, String> {
    private static final long serialVersionUID = 1L;

    private String name = "";

    @Override
    public boolean isZero() {
        return name.isEmpty();
    }

    @Override
    public ShownName copy() {
        ShownName copy = new ShownName();
        copy.name = name;
        return copy;
    }

    @Override
    public void reset() {
        name = "";
    }

    @Override
    public void add(String shown) {
        name = shown;
    }

    @Override
    public void merge(AccumulatorV2<String, String> other) {
        name = other.value();
    }

    @Override
    public String value() {
        return name;
    }
}
