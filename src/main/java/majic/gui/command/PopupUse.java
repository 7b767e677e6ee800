package majic.gui.command;

import majic.script.help.Completion;

/** What the popup of the command line shows and does: completions, or a search in the history. */
interface PopupUse {
    /** Called after the user has changed the line. */
    void edited();

    /** Uses an entry of the popup in the line. */
    void use(Completion entry);

    /** Hides the popup because of Esc or because the line loses the focus. */
    void close();
}
