package io.github.sofas.experiments;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * Public recordings of real cameras without a truth for every event. The recordings are known by file name, with the
 * sensor of those that do not name it.
 */
final class RealRecordings {
    private static final String DAVIS240 = "240x180";
    private static final Map<String, String> KNOWN = known();

    private RealRecordings() {
    }

    private static Map<String, String> known() {
        Map<String, String> known = new LinkedHashMap<>();
        for (String name : List.of("cars.aedat", "flip.aedat", "aeroplane.es", "moving-head.aedat4",
                "standing-up.aedat", "stripes.aedat", "building.aedat", "boxes-translation.aedat",
                "slider-depth.aedat", "shapes-rotation.aedat", "dark-box.aedat", "pendulum-ball.aedat",
                "shapes-translation-46ms.txt", "dynamic-rotation-19ms.txt", "walking-clamp.aedat", "cube.aedat",
                "boxes-rotation-5ms.txt", "poster-translation-11ms.txt", "screwdriver.aedat",
                "mouse-negative-time.aedat", "walking.aedat", "synthetic-square.aedat", "nmnist.bin")) {
            known.put(name, name.endsWith(".txt") ? DAVIS240 : null);
        }
        known.put("dark-box.aedat", "DVS128");
        known.put("synthetic-square.aedat", "DAVIS240C");
        known.put("nmnist.bin", "34x34");
        return known;
    }

    /** The known recordings in a folder with their sensors; if the folder has none, all its files without a sensor. */
    static Map<Path, String> in(Path folder) throws IOException {
        Map<Path, String> found = new LinkedHashMap<>();
        KNOWN.forEach((name, chip) -> {
            if (Files.isRegularFile(folder.resolve(name))) {
                found.put(folder.resolve(name), chip);
            }
        });
        if (found.isEmpty()) {
            try (Stream<Path> files = Files.list(folder)) {
                files.filter(Files::isRegularFile).sorted().forEach(file -> found.put(file, null));
            }
        }
        return found;
    }
}
