package majic.gui.command;

import java.awt.Color;
import javax.swing.text.AbstractDocument;
import javax.swing.text.Element;
import javax.swing.text.LabelView;
import javax.swing.text.StyleConstants;
import javax.swing.text.StyledEditorKit;
import javax.swing.text.View;
import javax.swing.text.ViewFactory;
import org.jspecify.annotations.Nullable;

/** Wraps text at the width of its component; breaks a word that is wider than that. */
final class WrappingKit extends StyledEditorKit {
    private static final long serialVersionUID = 1L;

    @Override
    public ViewFactory getViewFactory() {
        ViewFactory others = super.getViewFactory();
        return element -> AbstractDocument.ContentElementName.equals(element.getName())
                ? new BreakableText(element)
                : others.create(element);
    }

    private static final class BreakableText extends LabelView {
        BreakableText(Element element) {
            super(element);
        }

        /** Returns the background of the text's style too; the base class only finds one of the text itself. */
        @Override
        public @Nullable Color getBackground() {
            return (Color) getAttributes().getAttribute(StyleConstants.Background);
        }

        @Override
        public float getMinimumSpan(int axis) {
            return axis == View.X_AXIS ? 0 : super.getMinimumSpan(axis);
        }
    }
}
