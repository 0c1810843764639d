package io.github.sofas.flow.fit;

import java.util.Arrays;

/** Some linear equations with a symmetric matrix that is positive, solved by Cholesky's method. */
public final class LinearSystem {
    private final int size;
    /** The lower half of the matrix, then that of its factor. */
    private final double[][] a;

    /** Makes one of so many equations, whose matrix is 0. */
    public LinearSystem(int size) {
        this.size = size;
        a = new double[size][size];
    }

    /** Sets all entries to 0. */
    public void clear() {
        for (double[] row : a) {
            Arrays.fill(row, 0);
        }
    }

    /** Adds to an entry and to the one across the diagonal; j is not greater than i. */
    public void add(int i, int j, double value) {
        a[i][j] += value;
    }

    /** Sets an entry and the one across the diagonal; j is not greater than i. */
    void set(int i, int j, double value) {
        a[i][j] = value;
    }

    /** Takes the matrix apart into a lower triangle times itself; returns false where it is not positive. */
    public boolean factor() {
        for (int i = 0; i < size; i++) {
            for (int j = 0; j <= i; j++) {
                double left = a[i][j];
                for (int k = 0; k < j; k++) {
                    left -= a[i][k] * a[j][k];
                }
                if (i > j) {
                    a[i][j] = left / a[j][j];
                } else if (left > 0) {
                    a[i][i] = Math.sqrt(left);
                } else {
                    return false;
                }
            }
        }
        return true;
    }

    /** Turns the right sides of the equations into what solves them, once the matrix is taken apart. */
    public void solve(double[] x) {
        for (int i = 0; i < size; i++) {
            for (int k = 0; k < i; k++) {
                x[i] -= a[i][k] * x[k];
            }
            x[i] /= a[i][i];
        }
        for (int i = size - 1; i >= 0; i--) {
            for (int k = i + 1; k < size; k++) {
                x[i] -= a[k][i] * x[k];
            }
            x[i] /= a[i][i];
        }
    }

    /**
     * The least that the quadratic form of the matrix has where its last unknowns are these, whatever the others are;
     * once the matrix is taken apart.
     */
    double squareOfLast(double[] last) {
        int first = size - last.length;
        double sum = 0;
        for (int j = first; j < size; j++) {
            double entry = 0;
            for (int i = j; i < size; i++) {
                entry += a[i][j] * last[i - first];
            }
            sum += entry * entry;
        }
        return sum;
    }
}
