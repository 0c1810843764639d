package io.github.sofas.flow.fit;

import java.util.Arrays;

/** Linear equations with a symmetric, positive definite matrix, solved by Cholesky's method. */
public final class LinearSystem {
    private final int size;
    /** The lower half of the matrix; once factored, that of its factor. */
    private final double[][] a;

    /** Makes a system of so many equations, whose matrix is 0. */
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

    /** Adds to an entry and to its mirror image across the diagonal; j is not greater than i. */
    public void add(int i, int j, double value) {
        a[i][j] += value;
    }

    /** Sets an entry and its mirror image across the diagonal; j is not greater than i. */
    void set(int i, int j, double value) {
        a[i][j] = value;
    }

    /**
     * Factors the matrix into a lower triangle times its transpose; returns false where the matrix is not positive
     * definite.
     */
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

    /** Replaces the right sides of the equations by the solution, once the matrix is factored. */
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
     * The least value of the matrix's quadratic form over all other unknowns, where the last unknowns are these; once
     * the matrix is factored.
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
