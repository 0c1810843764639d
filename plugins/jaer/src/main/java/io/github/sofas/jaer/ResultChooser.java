package io.github.sofas.jaer;

import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;

/** Asks the user for the name of result files, and for consent before existing files are overwritten. */
final class ResultChooser {
    private ResultChooser() {
    }

    /**
     * Shows the dialogs; called on the thread of the windows.
     *
     * @param last the name that was chosen last
     * @return the chosen name; null if the user cancels
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
