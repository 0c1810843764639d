package io.github.sofas.jaer;

import java.util.ArrayList;
import java.util.List;

/**
 * Finds places for labels in a picture: beside the structures that they name, without overlaps, and within the picture.
 */
final class LabelLayout {
    /** Distance between a label and the structure that it names, in screen pixels. */
    static final float GAP = 3;
    /** Range of the search for a place, in heights of the label upwards and downwards, in quarter widths sideways. */
    private static final int FARTHEST = 12;

    private final Box picture;
    private final List<Box> taken = new ArrayList<>();

    LabelLayout(float width, float height) {
        picture = new Box(0, 0, width, height);
    }

    /** Keeps labels off a part of the picture. */
    void take(Box box) {
        taken.add(box);
    }

    /**
     * Finds the nearest free place for a label and takes it: above, below or beside the named structure, or else
     * farther off.
     *
     * @return the place; null if there is none
     */
    Box place(Box named, float width, float height) {
        List<Box> beside = List.of(Box.of(named.left(), named.top() + GAP, width, height),
            Box.of(named.left(), named.bottom() - GAP - height, width, height),
            Box.of(named.right() + GAP, named.top() - height, width, height),
            Box.of(named.left() - GAP - width, named.top() - height, width, height));
        for (Box candidate : beside) {
            Box within = within(candidate, named);
            if (within != null && isFree(within)) {
                take(within);
                return within;
            }
        }
        Box nearest = null;
        for (int row = -FARTHEST; row <= FARTHEST; row++) {
            for (int column = -FARTHEST; column <= FARTHEST; column++) {
                Box candidate = Box.of(named.left() + column * width / 4, named.top() + GAP + row * height, width,
                    height);
                if ((nearest == null || candidate.distance(named) < nearest.distance(named)) && isInside(candidate)
                        && isFree(candidate)) {
                    nearest = candidate;
                }
            }
        }
        if (nearest != null) {
            take(nearest);
        }
        return nearest;
    }

    /**
     * Moves a box sideways into the picture; null if it is above or below the picture, or would lie on the structure.
     */
    private Box within(Box box, Box named) {
        float left = Math.max(0, Math.min(box.left(), picture.right() - box.width()));
        Box moved = Box.of(left, box.bottom(), box.width(), box.height());
        return isInside(moved) && !moved.overlaps(named) ? moved : null;
    }

    private boolean isInside(Box box) {
        return box.left() >= picture.left() && box.right() <= picture.right() && box.bottom() >= picture.bottom()
            && box.top() <= picture.top();
    }

    private boolean isFree(Box box) {
        for (Box other : taken) {
            if (box.overlaps(other)) {
                return false;
            }
        }
        return true;
    }
}
