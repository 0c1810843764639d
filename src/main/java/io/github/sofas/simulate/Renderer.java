package io.github.sofas.simulate;

import io.github.sofas.event.SensorSize;
import java.util.List;

/**
 * Computes the light on each pixel, antialiased and slightly blurred, and finds the object that caused an event.
 *
 * <p>An object covers a pixel by a smooth function of the signed distance d from the pixel's centre to the outline:
 * 1/2 - 3/4 u + 1/4 u³ with u = d / reach, 1 inside and 0 outside. This is a straight edge seen through an
 * Epanechnikov kernel of standard deviation reach / sqrt 5. Coverage is exactly 0 or 1 beyond the reach, so only pixels
 * near an outline, or pixels that show a moving texture, can change. A quadtree over the sensor finds these pixels.
 * Inside its outline, a texture is drawn whenever it has moved by a step of its own, however fast other objects are.
 */
final class Renderer {
    /** Receives the light of each pixel that may have changed. */
    interface Visitor {
        /** Visits a pixel near the outline of at least one of the given objects. */
        void light(int pixel, int x, int y, long objects, double light);

        /** Visits a pixel that shows nothing but the texture of one object. */
        void texture(int pixel, int x, int y, int object, double logLight);
    }

    private static final int ROOT_SIZE = 64;
    private static final int LEAF_SIZE = 4;

    private final int width;
    private final int height;
    private final MovingObject[] objects;
    private final double[] background;
    private final double reach;
    private final double margin;
    private Pose[] before;
    private Pose[] now;
    private final double[] coverages;
    private final double[] pulls;
    private final int[] stepsPerDrawing;
    private final double[] logLights;
    private long step;

    /**
     * Makes a renderer.
     *
     * @param objects the objects, front to back
     * @param background light of each pixel where no object is
     * @param blurPx standard deviation of the blur in px
     * @param stepPx greatest distance that any point moves between two times, in px
     * @param stepsPerDrawing for each textured object, the number of steps in which its fastest point moves by that
     *     distance; 0 for objects that rest or have no texture
     */
    Renderer(SensorSize sensor, List<MovingObject> objects, double[] background, double blurPx, double stepPx,
             int[] stepsPerDrawing) {
        width = sensor.width();
        height = sensor.height();
        this.objects = objects.toArray(new MovingObject[0]);
        this.background = background;
        reach = blurPx * Math.sqrt(5);
        margin = reach + 1.5 * stepPx;
        before = poses(objects.size());
        now = poses(objects.size());
        coverages = new double[objects.size()];
        pulls = new double[objects.size()];
        this.stepsPerDrawing = stepsPerDrawing;
        logLights = new double[objects.size()];
        for (int i = 0; i < this.objects.length; i++) {
            logLights[i] = StrictMath.log(this.objects[i].light());
        }
    }

    private static Pose[] poses(int count) {
        Pose[] poses = new Pose[count];
        for (int i = 0; i < count; i++) {
            poses[i] = new Pose();
        }
        return poses;
    }

    /** Moves all objects to another time; {@link #cause} uses the poses of the last time. */
    void moveTo(double timeS) {
        Pose[] swap = before;
        before = now;
        now = swap;
        step++;
        for (int i = 0; i < objects.length; i++) {
            objects[i].trajectory().poseAt(timeS, now[i]);
        }
    }

    /** Computes the light of every pixel at the current time. */
    void renderAll(double[] light) {
        for (int y = 0, pixel = 0; y < height; y++) {
            for (int x = 0; x < width; x++, pixel++) {
                light[pixel] = lightAt(pixel, x, y, allObjects());
            }
        }
    }

    /** Visits every pixel whose light may have changed in the last step. */
    void visitChanging(Visitor visitor) {
        if (objects.length == 0) {
            return;
        }
        for (int y = 0; y < height; y += ROOT_SIZE) {
            for (int x = 0; x < width; x += ROOT_SIZE) {
                visit(x, y, ROOT_SIZE, allObjects(), visitor);
            }
        }
    }

    private long allObjects() {
        return objects.length == 0 ? 0 : -1L >>> (64 - objects.length);
    }

    private void visit(int left, int top, int size, long candidates, Visitor visitor) {
        double half = (size - 1) / 2.0;
        double far = half * Math.sqrt(2) + margin;
        long near = 0;
        boolean edge = false;
        for (long rest = candidates; rest != 0; rest &= rest - 1) {
            int i = Long.numberOfTrailingZeros(rest);
            double distance = now[i].distanceTo(objects[i].shape(), left + half, top + half);
            if (distance > far) {
                continue;
            }
            near |= 1L << i;
            if (distance < -far) {
                break;
            }
            edge = true;
        }
        if (!edge) {
            if (near != 0) {
                visitTexture(left, top, size, Long.numberOfTrailingZeros(near), visitor);
            }
            return;
        }
        if (size > LEAF_SIZE) {
            int quarter = size / 2;
            boolean right = left + quarter < width;
            boolean below = top + quarter < height;
            visit(left, top, quarter, near, visitor);
            if (right) {
                visit(left + quarter, top, quarter, near, visitor);
            }
            if (below) {
                visit(left, top + quarter, quarter, near, visitor);
            }
            if (right && below) {
                visit(left + quarter, top + quarter, quarter, near, visitor);
            }
            return;
        }
        int endX = Math.min(width, left + size);
        int endY = Math.min(height, top + size);
        for (int y = top; y < endY; y++) {
            for (int x = left; x < endX; x++) {
                int pixel = y * width + x;
                visitor.light(pixel, x, y, near, lightAt(pixel, x, y, near));
            }
        }
    }

    private void visitTexture(int left, int top, int size, int i, Visitor visitor) {
        if (stepsPerDrawing[i] == 0 || step % stepsPerDrawing[i] != 0) {
            return;
        }
        Texture texture = objects[i].texture();
        Pose pose = now[i];
        double alongX = pose.cos / pose.scale;
        double alongY = -pose.sin / pose.scale;
        int endX = Math.min(width, left + size);
        int endY = Math.min(height, top + size);
        for (int y = top; y < endY; y++) {
            double startX = pose.alongX(left, y);
            double startY = pose.alongY(left, y);
            for (int x = left; x < endX; x++) {
                int steps = x - left;
                double atX = pose.isView() ? pose.alongX(x, y) : startX + steps * alongX;
                double atY = pose.isView() ? pose.alongY(x, y) : startY + steps * alongY;
                visitor.texture(y * width + x, x, y, i, logLights[i] + texture.logLightAt(atX, atY));
            }
        }
    }

    private double lightAt(int pixel, int x, int y, long candidates) {
        double light = 0;
        double through = 1;
        for (long rest = candidates; rest != 0; rest &= rest - 1) {
            int i = Long.numberOfTrailingZeros(rest);
            double covered = coverage(now[i].distanceTo(objects[i].shape(), x, y));
            light += covered == 0 ? 0 : through * covered * objects[i].lightAt(now[i], x, y);
            through *= 1 - covered;
            if (through == 0) {
                return light;
            }
        }
        return light + through * background[pixel];
    }

    private double coverage(double distance) {
        if (distance >= reach) {
            return 0;
        }
        if (distance <= -reach) {
            return 1;
        }
        double u = distance / reach;
        return 0.5 - 0.75 * u + 0.25 * u * u * u;
    }

    /**
     * Finds the object that changed a pixel's light in the last step. This is the object that moved the light most in
     * the direction of the event, by the change of its coverage and of its own light there. Objects in front of it and
     * the light behind it are taken into account. Among equals, the topmost object wins.
     *
     * @param candidates the objects that {@link Visitor#light} was given for the pixel
     * @return the index of the object, front to back
     */
    int cause(int pixel, int x, int y, long candidates, int polarity) {
        double behind = background[pixel];
        int last = 63 - Long.numberOfLeadingZeros(candidates);
        for (int i = last; i >= 0; i--) {
            if ((candidates >>> i & 1) == 0) {
                continue;
            }
            Shape shape = objects[i].shape();
            double was = coverage(before[i].distanceTo(shape, x, y));
            double is = coverage(now[i].distanceTo(shape, x, y));
            double covered = (was + is) / 2;
            coverages[i] = covered;
            double lightWas = covered == 0 ? 0 : objects[i].lightAt(before[i], x, y);
            double lightIs = covered == 0 ? 0 : objects[i].lightAt(now[i], x, y);
            pulls[i] = ((is - was) * (lightIs - behind) + covered * (lightIs - lightWas)) * polarity;
            behind = covered * lightIs + (1 - covered) * behind;
        }
        double through = 1;
        double greatest = Double.NEGATIVE_INFINITY;
        int cause = last;
        for (long rest = candidates; rest != 0; rest &= rest - 1) {
            int i = Long.numberOfTrailingZeros(rest);
            double moved = through * pulls[i];
            if (pulls[i] != 0 && moved > greatest) {
                greatest = moved;
                cause = i;
            }
            through *= 1 - coverages[i];
        }
        return cause;
    }
}
