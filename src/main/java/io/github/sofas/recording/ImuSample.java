package io.github.sofas.recording;

/**
 * What the camera's inertial measurement unit said at one time: the numbers of its registers, in its own axes. What one
 * is worth depends on the range that the camera was set to, which recordings do not state: 65.5, 32.8 or 16.4 a deg/s
 * for a gyro range of 500, 1000 or 2000 deg/s. jAER's pan, tilt and roll rates are +y, -x and -z.
 *
 * @param timeUs time in µs, on the events' clock
 * @param gyroX rate of rotation about x, -32768 to 32767
 * @param gyroY the same about y
 * @param gyroZ the same about z
 */
public record ImuSample(long timeUs, int gyroX, int gyroY, int gyroZ) {
}
