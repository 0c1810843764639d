package io.github.sofas.spark;

import org.apache.spark.util.AccumulatorV2;

/** A name that Spark's UI shows in the row of each task. The driver keeps the last one only. */
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
