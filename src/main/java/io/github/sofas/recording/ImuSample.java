package io.github.sofas.recording;

/**
 * A reading of the camera's inertial measurement unit: the raw numbers of its registers, in its own axes. Their scale
 * depends on the range that the camera was set to, which most recordings do not state: 65.5, 32.8 or 16.4 per deg/s for
 * a gyro range of 500, 1000 or 2000 deg/s. jAER's pan, tilt and roll rates are +y, -x and -z.
 *
 * @param timeUs time in µs, on the events' clock
 * @param gyroX rate of rotation about x, -32768 to 32767
 * @param gyroY the same about y
 * @param gyroZ the same about z
 */
public record ImuSample(long timeUs, int gyroX, int gyroY, int gyroZ) {
}
