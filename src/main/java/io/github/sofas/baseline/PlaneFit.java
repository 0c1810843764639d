package io.github.sofas.baseline;

/**
 * Total least-squares fit of a plane a x + b y + c t + d = 0, with a² + b² + c² + d² = 1, to points (x, y, t). The
 * plane is the eigenvector of the smallest eigenvalue of the sum of (x, y, t, 1)ᵀ (x, y, t, 1). Holds the points in
 * arrays that are reused, so that a fit allocates nothing.
 */
final class PlaneFit {
    private static final int N = 4;
    private static final int MAX_SWEEPS = 30;

    private final double[] x;
    private final double[] y;
    private final double[] t;
    private int size;
    private final double[] matrix = new double[N * N];
    private final double[] vectors = new double[N * N];
    private final double[] plane = new double[N];

    PlaneFit(int capacity) {
        x = new double[capacity];
        y = new double[capacity];
        t = new double[capacity];
    }

    void clear() {
        size = 0;
    }

    void add(double pointX, double pointY, double pointT) {
        x[size] = pointX;
        y[size] = pointY;
        t[size] = pointT;
        size++;
    }

    int size() {
        return size;
    }

    /** Returns (a, b, c, d) of the last fit; the next fit overwrites the array. */
    double[] plane() {
        return plane;
    }

    /**
     * Drops the points that are farther than a distance from the last plane.
     *
     * @return whether any point was dropped
     */
    boolean dropFartherThan(double distance) {
        int kept = 0;
        for (int i = 0; i < size; i++) {
            if (Math.abs(plane[0] * x[i] + plane[1] * y[i] + plane[2] * t[i] + plane[3]) <= distance) {
                x[kept] = x[i];
                y[kept] = y[i];
                t[kept] = t[i];
                kept++;
            }
        }
        boolean dropped = kept < size;
        size = kept;
        return dropped;
    }

    /**
     * Fits the plane to the points.
     *
     * @return how far (a, b, c, d) moved from the last fit, with the sign chosen that moves it less
     */
    double fit() {
        double[] m = matrix;
        java.util.Arrays.fill(m, 0);
        for (int i = 0; i < size; i++) {
            double px = x[i];
            double py = y[i];
            double pt = t[i];
            m[0] += px * px;
            m[1] += px * py;
            m[2] += px * pt;
            m[3] += px;
            m[5] += py * py;
            m[6] += py * pt;
            m[7] += py;
            m[10] += pt * pt;
            m[11] += pt;
        }
        m[15] = size;
        int smallest = eigenvectors(m, vectors);
        double towards = 0;
        double away = 0;
        for (int k = 0; k < N; k++) {
            double value = vectors[k * N + smallest];
            towards += (value - plane[k]) * (value - plane[k]);
            away += (value + plane[k]) * (value + plane[k]);
        }
        double sign = towards <= away ? 1 : -1;
        for (int k = 0; k < N; k++) {
            plane[k] = sign * vectors[k * N + smallest];
        }
        return Math.sqrt(Math.min(towards, away));
    }

    /**
     * Diagonalises a symmetric matrix by Jacobi rotations. Only the upper half of the matrix is read. The product of
     * the rotations holds the eigenvectors, in columns.
     *
     * @return the column of the smallest eigenvalue
     */
    private static int eigenvectors(double[] m, double[] v) {
        for (int k = 0; k < N * N; k++) {
            v[k] = k % (N + 1) == 0 ? 1 : 0;
        }
        for (int sweep = 0; sweep < MAX_SWEEPS && offDiagonal(m); sweep++) {
            for (int p = 0; p < N - 1; p++) {
                for (int q = p + 1; q < N; q++) {
                    turn(m, v, p, q);
                }
            }
        }
        int smallest = 0;
        for (int k = 1; k < N; k++) {
            if (m[k * N + k] < m[smallest * N + smallest]) {
                smallest = k;
            }
        }
        return smallest;
    }

    /** Whether an off-diagonal element is still significant beside the diagonal elements of its row and column. */
    private static boolean offDiagonal(double[] m) {
        for (int p = 0; p < N - 1; p++) {
            for (int q = p + 1; q < N; q++) {
                double limit = Math.sqrt(Math.abs(m[p * N + p]) * Math.abs(m[q * N + q]));
                if (Math.abs(m[p * N + q]) > 1e-15 * limit && Math.abs(m[p * N + q]) > Double.MIN_NORMAL) {
                    return true;
                }
            }
        }
        return false;
    }

    private static void turn(double[] m, double[] v, int p, int q) {
        double pq = m[p * N + q];
        if (pq == 0) {
            return;
        }
        double theta = (m[q * N + q] - m[p * N + p]) / (2 * pq);
        double tan = Math.copySign(1, theta) / (Math.abs(theta) + Math.sqrt(theta * theta + 1));
        double cos = 1 / Math.sqrt(tan * tan + 1);
        double sin = tan * cos;
        m[p * N + p] -= tan * pq;
        m[q * N + q] += tan * pq;
        m[p * N + q] = 0;
        for (int k = 0; k < N; k++) {
            if (k != p && k != q) {
                int kp = Math.min(k, p) * N + Math.max(k, p);
                int kq = Math.min(k, q) * N + Math.max(k, q);
                double a = m[kp];
                double b = m[kq];
                m[kp] = cos * a - sin * b;
                m[kq] = sin * a + cos * b;
            }
            double a = v[k * N + p];
            double b = v[k * N + q];
            v[k * N + p] = cos * a - sin * b;
            v[k * N + q] = sin * a + cos * b;
        }
    }
}
