package io.github.sofas.flow.track;

/** The contours that may hide a part of a structure, because their boxes overlap its own. Ours. */
final class Covers {
    /** Most that are told apart. */
    private static final int CAPACITY = 8;
    /** Events inside, to those as dense as outside, below which some are hidden: a part of what covers is open. */
    private static final double HIDDEN_INSIDE = 0.8;
    /** Events of the structure that are asked whether they lie inside. */
    private static final int ASKED = 256;

    private final Contour[] covers = new Contour[CAPACITY];
    private int size;
    private double share;

    /** Forgets all. */
    void clear() {
        size = 0;
        share = 0;
    }

    /** Adds one that covers a structure's contour as far as their boxes overlap at a time. */
    void add(Contour own, Contour cover, long nowUs) {
        double dx = cover.travelX(nowUs) - own.travelX(nowUs);
        double dy = cover.travelY(nowUs) - own.travelY(nowUs);
        double columns = Math.min(own.right(), cover.right() + dx) - Math.max(own.left(), cover.left() + dx) + 1;
        double rows = Math.min(own.bottom(), cover.bottom() + dy) - Math.max(own.top(), cover.top() + dy) + 1;
        double box = (own.right() - own.left() + 1.0) * (own.bottom() - own.top() + 1.0);
        share += Math.max(0, columns) * Math.max(0, rows) / Math.max(1, box);
        if (size < CAPACITY) {
            covers[size++] = cover;
        }
    }

    /** Share of the structure's box that is covered, more than 1 where several cover the same. */
    double share() {
        return share;
    }

    /**
     * Whether a structure has fewer events inside than outside, for its size, or is covered whole.
     *
     * @param marginPx how far events of a cover itself may lie inside its border
     */
    boolean hideSome(LiveEvents live, double marginPx) {
        if (share >= 1) {
            return true;
        }
        int stride = Math.max(1, live.size() / ASKED);
        int inside = 0;
        int asked = 0;
        for (int k = 0; k < live.size(); k += stride) {
            int i = live.index(k);
            asked++;
            if (contains(live.x[i], live.y[i], live.timeUs[i], marginPx)) {
                inside++;
            }
        }
        return inside * (1 - share) <= HIDDEN_INSIDE * (asked - inside) * share;
    }

    private boolean contains(int x, int y, long timeUs, double marginPx) {
        for (int c = 0; c < size; c++) {
            Contour cover = covers[c];
            double column = x - cover.travelX(timeUs);
            double row = y - cover.travelY(timeUs);
            if (column >= cover.left() + marginPx && column <= cover.right() - marginPx
                    && row >= cover.top() + marginPx && row <= cover.bottom() - marginPx) {
                return true;
            }
        }
        return false;
    }
}
