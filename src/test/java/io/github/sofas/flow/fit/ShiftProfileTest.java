package io.github.sofas.flow.fit;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import org.junit.Test;

public class ShiftProfileTest {
    @Test
    public void shiftsAreCountedInAPowerOfTwoThatBringsTheGreatestBelowTwoToTheFourteen() {
        ShiftProfile profile = new ShiftProfile(8);
        // 3/4 = 12288/16384; a 40,000th is 0.41 of the unit
        profile.take(new float[] {-0.75f, 0.125f, 0, 0.000025f, 0.5f, 99}, 5);
        assertArrayEquals(new int[] {-12288, 2048, 0, 0, 8192, 0, 0, 0}, profile.shift);
        assertEquals(1.0 / 16384, profile.unit(), 0);
    }

    @Test
    public void eventsThatDoNotShiftStay() {
        ShiftProfile profile = new ShiftProfile(2);
        profile.take(new float[2], 2);
        assertArrayEquals(new int[2], profile.shift);
        assertEquals(0, profile.unit(), 0);
    }

    @Test
    public void productsOfShiftsAreCountedInPowersOfTwo() {
        ShiftProfile one = new ShiftProfile(3);
        ShiftProfile other = new ShiftProfile(3);
        one.take(new float[] {-0.75f, 0.5f, 0}, 3);
        other.take(new float[] {0.75f, 0.25f, 0.5f}, 3);
        ShiftProfile product = new ShiftProfile(3);
        product.takeProduct(one, other, 3);
        // 12288² has 28 bits, 14 too many: 9/16 = 9216/16384
        assertArrayEquals(new int[] {-9216, 2048, 0}, product.shift);
        assertEquals(1.0 / 16384, product.unit(), 0);
        assertEquals(9216, product.most());
    }

    @Test
    public void productWithWhatDoesNotShiftStays() {
        ShiftProfile still = new ShiftProfile(2);
        still.take(new float[2], 2);
        ShiftProfile product = new ShiftProfile(2);
        product.takeProduct(still, still, 2);
        assertArrayEquals(new int[2], product.shift);
        assertEquals(0, product.unit(), 0);
    }
}
