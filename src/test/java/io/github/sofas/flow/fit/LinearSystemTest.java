package io.github.sofas.flow.fit;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Three linear equations with a symmetric matrix. */
public class LinearSystemTest {
    private static LinearSystem system(double[]... lowerHalf) {
        LinearSystem system = new LinearSystem(lowerHalf.length);
        for (int i = 0; i < lowerHalf.length; i++) {
            for (int j = 0; j <= i; j++) {
                system.set(i, j, lowerHalf[i][j]);
            }
        }
        return system;
    }

    @Test
    public void solutionFulfilsTheEquations() {
        LinearSystem system = system(new double[] {4}, new double[] {2, 5}, new double[] {0, 1, 3});
        assertTrue(system.factor());
        // (1, -2, 3) times the matrix
        double[] x = {4 - 4, 2 - 10 + 3, -2 + 9};
        system.solve(x);
        assertArrayEquals(new double[] {1, -2, 3}, x, 1e-12);
    }

    @Test
    public void entriesAddUpUntilTheyAreCleared() {
        LinearSystem system = system(new double[] {7}, new double[] {3, 9});
        assertTrue(system.factor());
        system.clear();
        system.add(0, 0, 1);
        system.add(0, 0, 3);
        system.add(1, 0, 2);
        system.add(1, 1, 5);
        assertTrue(system.factor());
        // (1, -2) times (4 2, 2 5)
        double[] x = {4 - 4, 2 - 10};
        system.solve(x);
        assertArrayEquals(new double[] {1, -2}, x, 1e-12);
    }

    @Test
    public void matrixThatIsNotPositiveHasNoFactor() {
        assertFalse(system(new double[] {1}, new double[] {2, 1}).factor());
        assertFalse(system(new double[] {0}, new double[] {0, 1}).factor());
        assertFalse(system(new double[] {Double.NaN}, new double[] {0, 1}).factor());
    }

    @Test
    public void quadraticFormIsLeastInTheOtherUnknowns() {
        // 4 x² + 4 x y + 5 y² with y = 3: x = -1.5, 9 - 18 + 45
        LinearSystem system = system(new double[] {4}, new double[] {2, 5});
        assertTrue(system.factor());
        assertEquals(36, system.squareOfLast(new double[] {3}), 1e-12);
        // with both as they are, 4 + 12 + 45
        assertEquals(61, system.squareOfLast(new double[] {1, 3}), 1e-12);
    }
}
