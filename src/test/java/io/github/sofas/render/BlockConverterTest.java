package io.github.sofas.render;

import static org.junit.Assert.assertEquals;

import java.util.Arrays;
import java.util.Random;
import org.junit.Test;

/** Blocks of a picture of 32 x 16 px, of which the second one is converted. */
public class BlockConverterTest {
    private final BlockPicture picture = new BlockPicture(2, 1);

    private int convert(BlockConverter converter, int[] rgb) {
        return converter.convert(rgb, 16, 32, picture.words, picture.block(1, 0));
    }

    /** BT.601, in 256ths: 66 R + 129 G + 25 B, and 16 more; -38 R - 74 G + 112 B; 112 R - 94 G - 18 B. */
    @Test
    public void coloursAreThoseOfVideo() {
        int[] rgb = new int[32 * 16];
        Arrays.fill(rgb, 0xE69F00);
        convert(new BlockConverter(), rgb);
        // R 230, G 159: 16 + 139, -80, 42
        assertEquals(16 + 139 - 128, picture.value(0, 16 + 5, 9));
        assertEquals(-80, picture.value(1, 8 + 7, 7));
        assertEquals(42, picture.value(2, 8, 0));
        Arrays.fill(rgb, 0xFFFFFF);
        convert(new BlockConverter(), rgb);
        assertEquals(235 - 128, picture.value(0, 31, 15));
        assertEquals(0, picture.value(1, 15, 7));
        assertEquals(0, picture.value(2, 15, 7));
        assertEquals("the block beside", 0, picture.value(0, 15, 15));
    }

    /** Every pixel and every four of them has its place, whatever the converter met before. */
    @Test
    public void valuesAreWhereTheirPixelsAre() {
        Random random = new Random(4);
        int[] rgb = new int[32 * 16];
        BlockConverter converter = new BlockConverter();
        for (int n = 0; n < 50; n++) {
            for (int i = 0; i < rgb.length; i++) {
                int above = i >= 32 && random.nextInt(n + 1) > 0 ? rgb[i - 32] : random.nextInt(3) * 0x406080;
                rgb[i] = i % 2 == 1 && random.nextInt(n + 1) > 0 ? rgb[i - 1] : above;
            }
            convert(converter, rgb);
            for (int y = 0; y < 16; y++) {
                for (int x = 16; x < 32; x++) {
                    int c = rgb[y * 32 + x];
                    int luma = 16 - 128 + (66 * (c >> 16) + 129 * (c >> 8 & 0xFF) + 25 * (c & 0xFF) + 128 >> 8);
                    assertEquals(x + "," + y, luma, picture.value(0, x, y));
                    int[] four = {rgb[(y & ~1) * 32 + (x & ~1)], rgb[(y & ~1) * 32 + (x | 1)],
                        rgb[(y | 1) * 32 + (x & ~1)], rgb[(y | 1) * 32 + (x | 1)]};
                    int r = Arrays.stream(four).map(p -> p >> 16).sum();
                    int g = Arrays.stream(four).map(p -> p >> 8 & 0xFF).sum();
                    int b = Arrays.stream(four).map(p -> p & 0xFF).sum();
                    assertEquals((byte) (-38 * r - 74 * g + 112 * b + 512 >> 10), picture.value(1, x / 2, y / 2));
                    assertEquals((byte) (112 * r - 94 * g - 18 * b + 512 >> 10), picture.value(2, x / 2, y / 2));
                }
            }
        }
    }

    @Test
    public void partsThatAreNotAsTheyWereAreTold() {
        int[] rgb = new int[32 * 16];
        BlockConverter converter = new BlockConverter();
        convert(converter, rgb);
        assertEquals(0, convert(converter, rgb));
        // column 5, row 6 of the block: the sixth part of brightness, the first of blue and red
        rgb[6 * 32 + 16 + 5] = 0x0000FF;
        assertEquals(1 << 5 | 1 << 16 | 1 << 20, convert(converter, rgb));
        rgb[15 * 32 + 31] = 0x0000FF;
        assertEquals(1 << 15 | 1 << 19 | 1 << 23, convert(converter, rgb));
        assertEquals(0, convert(converter, rgb));
    }
}
