package io.github.sofas.jaer;

import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;

/** Asks the user for the name of results, and before it overwrites some. */
final class ResultChooser {
    private ResultChooser() {
    }

    /**
     * Shows the dialogs, on the thread of the windows.
     *
     * @param last what was chosen last
     * @return null where the user does not want to
     */
    static Path choose(Component above, String last) {
        JFileChooser chooser = new JFileChooser();
        chooser.setDialogTitle("Write NAME.flow.csv, NAME.segments.csv and NAME.tracks.csv");
        chooser.setSelectedFile(new File(last));
        while (chooser.showSaveDialog(above) == JFileChooser.APPROVE_OPTION) {
            Path name = chooser.getSelectedFile().toPath();
            List<Path> existing = SessionLog.existing(name);
            if (existing.isEmpty() || JOptionPane.showConfirmDialog(above, question(existing), "Overwrite?",
                    JOptionPane.YES_NO_OPTION) == JOptionPane.YES_OPTION) {
                return name;
            }
        }
        return null;
    }

    static String question(List<Path> existing) {
        return existing.stream().map(path -> path.getFileName().toString()).collect(Collectors.joining(", "))
            + (existing.size() == 1 ? " exists" : " exist") + " in " + existing.get(0).toAbsolutePath().getParent()
            + ". Overwrite?";
    }
}
