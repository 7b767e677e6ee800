package majic.gui.kit;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Window;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import javax.imageio.ImageIO;
import majic.environment.Settings;
import majic.file.WholeFile;
import majic.panel.PictureView;
import majic.text.IoReason;
import majic.text.Texts;

/** Shows a robot's camera pictures as large as its window, and saves one of them as a PNG file. */
public final class PictureDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(PictureDialog.class);
    private static final Dimension LARGE = new Dimension(640, 480);
    private static final Dimension LEAST = new Dimension(320, 280);

    private final PictureView large;
    private final transient Settings settings;

    /**
     * Creates a dialog that is not shown yet.
     *
     * @param view shows the same pictures elsewhere
     */
    public PictureDialog(Window owner, PictureView view, Settings settings) {
        super(owner, view.title());
        this.settings = settings;
        large = view.copy(UIScale.scale(LARGE.width), UIScale.scale(LARGE.height));
        fill(large, button(TEXTS.get("savePicture.button"), this::save), closing(TEXTS.get("close")));
        setMinimumSize(UIScale.scale(LEAST));
    }

    /** Asks for a file for the picture that is shown now. */
    private void save() {
        large.image()
                .ifPresent(picture -> ChooseFile.toSave(
                        this, settings, TEXTS.get("savePicture"), "picture.png", file -> write(picture, file)));
    }

    private static Optional<String> write(BufferedImage picture, Path file) {
        try {
            WholeFile.replace(file, out -> {
                if (!ImageIO.write(picture, "png", out)) {
                    throw new IOException(TEXTS.get("notPng"));
                }
            });
            return Optional.empty();
        } catch (IOException e) {
            return Optional.of(TEXTS.get("notWritten", file, IoReason.of(e)));
        }
    }
}
