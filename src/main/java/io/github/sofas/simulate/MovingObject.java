package io.github.sofas.simulate;

/**
 * A rigid, evenly grey object.
 *
 * @param id what the truth calls it, from 1
 * @param shape its outline
 * @param motion its path
 * @param light its brightness as a multiple of the background's, above 0
 */
record MovingObject(int id, Shape shape, Motion motion, double light) {
}
