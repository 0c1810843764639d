package io.github.sofas.simulate;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.SensorSize;
import java.util.Arrays;
import java.util.Random;

/**
 * A scene as an event source. The scene is filmed step by step while the source is read, so that even an endless film
 * needs little memory.
 *
 * <p>Each pixel's log intensity changes linearly from one time step to the next, so that events have times between the
 * steps. A step is as long as the fastest point needs for a quarter pixel, but at most 10 ms. The truth of an event is
 * the object that caused it, and the velocity of that object's point at the pixel's centre. The velocity is that at the
 * moment of the event, before its latency.
 */
public final class SimulatedSource implements EventSource {
    /** Greatest distance that anything moves within one time step, in px. */
    static final double STEP_PX = 0.25;

    private static final double LONGEST_STEP_US = 10_000;
    private static final int EVENTS_AT_A_TIME = 8192;
    private static final int TEXTURE_CELL_PX = 5;
    private static final int SPEED_SAMPLES = 200;
    private static final double LAMP_STEP_PERIODS = 0.05;

    private final SensorSize sensor;
    private final DvsModel dvs;
    private final World world;
    private final long passes;
    private final long durationUs;
    private final double stepUs;
    /** An event may be found as late as this after its time, in µs, because a texture is not drawn in every step. */
    private final double longestDrawingUs;

    private final Renderer renderer;
    private final PixelArray pixels;
    private final double[] light;
    private final long textured;
    private final double[] startLight;
    /** When each pixel's light was last drawn, for pixels near textures. */
    private final double[] drawnUs;
    private final long[] lastOutUs;
    private final int[] hotPixels;
    private final Random latency;
    private final Random noise;
    private final EventQueue queue = new EventQueue();
    private final Pose causePose = new Pose();
    private final Renderer.Visitor pixelsThatChange = new Changes();
    private final PixelArray.Crossing crossed = this::crossed;

    private long pass;
    private long passStartUs;
    private double nowUs;
    private double nextUs;
    private double nextNoiseUs;
    private double nextHotUs;
    private int visitedX;
    private int visitedY;
    private long visitedObjects;
    private boolean finished;

    /**
     * Films a scene once.
     *
     * @param scene the scene
     * @param options how the scene is filmed
     */
    public SimulatedSource(Scene scene, SimulationOptions options) {
        this(scene, options, 1);
    }

    /**
     * Films a scene several times, each pass after the previous one in time. Between two passes, the objects jump back
     * without an event, and noise continues.
     *
     * @param scene the scene
     * @param options how the scene is filmed
     * @param passes number of passes, at least 1; Long.MAX_VALUE for a source without end
     * @throws IllegalArgumentException if there are fewer passes
     */
    public SimulatedSource(Scene scene, SimulationOptions options, long passes) {
        this(scene.compose(options), options, passes);
    }

    SimulatedSource(World world, SimulationOptions options, long passes) {
        if (passes < 1) {
            throw new IllegalArgumentException("passes must be at least 1 but was " + passes);
        }
        this.world = world;
        this.passes = passes;
        sensor = options.sensor();
        dvs = options.dvs();
        durationUs = Math.max(1, Math.round(world.durationS() * 1e6));
        double fastest = 0;
        for (MovingObject object : world.objects()) {
            fastest = Math.max(fastest, maxSpeedPxPerS(object));
        }
        double longestUs = world.lamp() == null ? LONGEST_STEP_US : LAMP_STEP_PERIODS * Lamp.periodS() * 1e6;
        stepUs = fastest == 0 ? longestUs : Math.min(longestUs, STEP_PX / fastest * 1e6);
        int size = sensor.width() * sensor.height();
        Random seeds = new Random(options.seed());
        Random mismatch = new Random(seeds.nextLong());
        latency = new Random(seeds.nextLong());
        noise = new Random(seeds.nextLong());
        pixels = new PixelArray(size, dvs, mismatch);
        int[] stepsPerDrawing = stepsPerDrawing();
        longestDrawingUs = stepUs * Arrays.stream(stepsPerDrawing).max().orElse(0);
        renderer = new Renderer(sensor, world.objects(),
                background(options.texture(), new Random(seeds.nextLong())), options.blurPx(), STEP_PX,
                stepsPerDrawing);
        hotPixels = new Random(seeds.nextLong()).ints(0, size).distinct()
                .limit(Math.min(dvs.hotPixels(), size)).toArray();
        light = new double[size];
        startLight = new double[size];
        drawnUs = new double[size];
        textured = textured(world);
        lastOutUs = new long[size];
        Arrays.fill(lastOutUs, -1);
        renderer.moveTo(0);
        renderer.renderAll(startLight);
        nextNoiseUs = gapUs(dvs.noiseHzPerPx() * size);
        nextHotUs = gapUs(dvs.hotPixelHz() * hotPixels.length);
        startPass();
    }

    private double maxSpeedPxPerS(MovingObject object) {
        Trajectory trajectory = object.trajectory();
        double radius = object.shape().radius() * trajectory.maxScale();
        if (Double.isInfinite(radius)) {
            return maxSpeedInCorners(trajectory);
        }
        double diagonal = Math.sqrt((double) sensor.width() * sensor.width()
                + (double) sensor.height() * sensor.height());
        // No visible point is farther from its object's origin than the object's reach or the sensor's diagonal.
        return trajectory.maxSpeedPxPerS(Math.min(radius, diagonal));
    }

    /** Greatest speed of a picture that slides, turns, grows or follows a turning camera: it occurs in a corner. */
    private double maxSpeedInCorners(Trajectory trajectory) {
        double fastest = 0;
        Pose pose = new Pose();
        for (int k = 0; k <= SPEED_SAMPLES; k++) {
            trajectory.poseAt(world.durationS() * k / SPEED_SAMPLES, pose);
            for (int corner = 0; corner < 4; corner++) {
                double x = corner % 2 * (sensor.width() - 1);
                double y = corner / 2 * (sensor.height() - 1);
                fastest = Math.max(fastest, Math.hypot(pose.vxAt(x, y), pose.vyAt(x, y)));
            }
        }
        return fastest;
    }

    /** Number of steps in which each textured object moves as far as it may between two drawings; 0 if it rests. */
    private int[] stepsPerDrawing() {
        return world.objects().stream().mapToInt(object -> {
            double speed = object.texture() == null ? 0 : maxSpeedPxPerS(object);
            return speed == 0 ? 0 : (int) Math.max(1, STEP_PX / speed * 1e6 / stepUs);
        }).toArray();
    }

    /** Light of the background as value noise: normally distributed values every few pixels, joined smoothly. */
    private double[] background(double texture, Random random) {
        int width = sensor.width();
        int height = sensor.height();
        int columns = width / TEXTURE_CELL_PX + 2;
        double[] knots = new double[columns * (height / TEXTURE_CELL_PX + 2)];
        if (texture > 0) {
            for (int i = 0; i < knots.length; i++) {
                knots[i] = texture * random.nextGaussian();
            }
        }
        double[] background = new double[width * height];
        for (int y = 0, pixel = 0; y < height; y++) {
            double shareY = smooth((double) (y % TEXTURE_CELL_PX) / TEXTURE_CELL_PX);
            for (int x = 0; x < width; x++, pixel++) {
                double shareX = smooth((double) (x % TEXTURE_CELL_PX) / TEXTURE_CELL_PX);
                int knot = y / TEXTURE_CELL_PX * columns + x / TEXTURE_CELL_PX;
                double above = knots[knot] + shareX * (knots[knot + 1] - knots[knot]);
                double below = knots[knot + columns]
                        + shareX * (knots[knot + columns + 1] - knots[knot + columns]);
                background[pixel] = StrictMath.exp(above + shareY * (below - above));
            }
        }
        return background;
    }

    private static double smooth(double share) {
        return share * share * (3 - 2 * share);
    }

    private void startPass() {
        nowUs = 0;
        renderer.moveTo(0);
        System.arraycopy(startLight, 0, light, 0, light.length);
        Arrays.fill(drawnUs, 0);
        pixels.restart(light);
    }

    @Override
    public SensorSize sensor() {
        return sensor;
    }

    /** {@return the duration of one pass in µs} */
    public long durationUs() {
        return durationUs;
    }

    /** {@return the number of objects in the scene; the truth numbers them from 1} */
    public int objects() {
        return (int) world.objects().stream().mapToInt(MovingObject::id).distinct().count();
    }

    @Override
    public boolean next(EventBatch batch) {
        return next(batch, null);
    }

    /**
     * Clears the batch and fills it with events, and the truth with the truth of each event.
     *
     * @param batch receives the events
     * @param truth at least as large as the batch, or null if it is not needed
     * @return false at the end, with the batch left empty
     * @throws IllegalArgumentException if the truth is smaller than the batch
     */
    public boolean next(EventBatch batch, Truth truth) {
        if (truth != null && truth.capacity() < batch.capacity()) {
            throw new IllegalArgumentException("truth must hold at least " + batch.capacity()
                    + " events, as the batch does, but holds " + truth.capacity());
        }
        batch.clear();
        while (!batch.isFull()) {
            queue.drainTo(batch, truth);
            if (!batch.isFull() && !film()) {
                break;
            }
        }
        return batch.size() > 0;
    }

    @Override
    public void close() {
        finished = true;
    }

    /** Films until some events are ready; false if no more events will come. */
    private boolean film() {
        while (!queue.hasReady()) {
            if (finished) {
                return false;
            }
            do {
                step();
            } while (queue.gathered() < EVENTS_AT_A_TIME && nowUs < durationUs);
            if (nowUs < durationUs) {
                queue.release(passStartUs + (long) (nowUs - longestDrawingUs));
                continue;
            }
            pass++;
            passStartUs += durationUs;
            nextNoiseUs -= durationUs;
            nextHotUs -= durationUs;
            if (pass == passes) {
                finished = true;
                queue.release(Long.MAX_VALUE);
            } else {
                queue.release(passStartUs);
                startPass();
            }
        }
        return true;
    }

    private void step() {
        nextUs = Math.min(durationUs, nowUs + stepUs);
        renderer.moveTo(nextUs * 1e-6);
        renderer.visitChanging(pixelsThatChange);
        if (world.lamp() != null) {
            flicker(world.lamp());
        }
        addNoise();
        nowUs = nextUs;
    }

    private static long textured(World world) {
        long textured = 0;
        for (int i = 0; i < world.objects().size(); i++) {
            textured |= world.objects().get(i).texture() == null ? 0 : 1L << i;
        }
        return textured;
    }

    /** Passes the light that the renderer finds on to the pixels. */
    private final class Changes implements Renderer.Visitor {
        @Override
        public void light(int pixel, int x, int y, long objects, double newLight) {
            // A texture is not drawn in every step. Without texture, a pixel that was not visited kept its light.
            double fromUs = (objects & textured) == 0 ? nowUs : drawnUs[pixel];
            drawnUs[pixel] = nextUs;
            if (light[pixel] != newLight) {
                light[pixel] = newLight;
                visit(x, y, objects);
                pixels.change(pixel, StrictMath.log(newLight), fromUs, nextUs, crossed);
            }
        }

        @Override
        public void texture(int pixel, int x, int y, int object, double logLight) {
            // The stored light does not describe a pixel with texture: whatever light comes next is a change.
            light[pixel] = Double.NaN;
            visit(x, y, 1L << object);
            pixels.change(pixel, logLight, drawnUs[pixel], nextUs, crossed);
            drawnUs[pixel] = nextUs;
        }

        private void visit(int x, int y, long objects) {
            visitedX = x;
            visitedY = y;
            visitedObjects = objects;
        }
    }

    private void flicker(Lamp lamp) {
        visitedObjects = 0;
        int[] lit = lamp.pixels();
        for (int i = 0; i < lit.length; i++) {
            int pixel = lit[i];
            visitedX = pixel % sensor.width();
            visitedY = pixel / sensor.width();
            pixels.change(pixel, StrictMath.log(startLight[pixel]) + lamp.logLight(i, nextUs * 1e-6), nowUs, nextUs,
                crossed);
        }
    }

    private void crossed(int pixel, double timeUs, int polarity) {
        int x = visitedX;
        int y = visitedY;
        if (visitedObjects == 0) {
            queue.add(outUs(pixel, timeUs), x, y, polarity, 0, 0, 0);
            return;
        }
        MovingObject object = world.objects().get(renderer.cause(pixel, x, y, visitedObjects, polarity));
        object.trajectory().poseAt(timeUs * 1e-6, causePose);
        queue.add(outUs(pixel, timeUs), x, y, polarity,
                (float) causePose.vxAt(x, y), (float) causePose.vyAt(x, y), object.id());
    }

    private void addNoise() {
        int size = light.length;
        while (nextNoiseUs < nextUs) {
            fireUnprompted(noise.nextInt(size), nextNoiseUs, noise.nextBoolean() ? 1 : -1);
            nextNoiseUs += gapUs(dvs.noiseHzPerPx() * size);
        }
        while (nextHotUs < nextUs) {
            fireUnprompted(hotPixels[noise.nextInt(hotPixels.length)], nextHotUs, 1);
            nextHotUs += gapUs(dvs.hotPixelHz() * hotPixels.length);
        }
    }

    private void fireUnprompted(int pixel, double timeUs, int polarity) {
        if (pixels.fireUnprompted(pixel, timeUs)) {
            int width = sensor.width();
            queue.add(outUs(pixel, timeUs), pixel % width, pixel / width, polarity, 0, 0, 0);
        }
    }

    /** Time to the next event of a Poisson process; infinite if the rate is 0. */
    private double gapUs(double rateHz) {
        return rateHz == 0 ? Double.POSITIVE_INFINITY : -StrictMath.log(1 - noise.nextDouble()) / rateHz * 1e6;
    }

    /** The time stamp: the crossing plus latency, but after the pixel's last event, because a pixel keeps its order. */
    private long outUs(int pixel, double timeUs) {
        double sd = dvs.jitterSdUs();
        double delayUs = sd == 0 ? 0 : sd * Math.min(6, Math.max(0, 3 + latency.nextGaussian()));
        long outUs = Math.max(passStartUs + (long) (timeUs + delayUs), lastOutUs[pixel] + 1);
        lastOutUs[pixel] = outUs;
        return outUs;
    }
}
