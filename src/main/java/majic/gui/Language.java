package majic.gui;

import java.util.Locale;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.UIManager;
import majic.environment.Settings;
import majic.gui.kit.BackgroundSettings;
import majic.text.Texts;

/**
 * A language of the windows, to choose for the next start. MAJIC Script, the console and the log are English in any
 * case.
 */
enum Language {
    /** That of the computer, or English if there are no texts in it. */
    SYSTEM("system", "language.system"),
    ENGLISH("en", "language.en"),
    GERMAN("de", "language.de");

    private static final Texts TEXTS = Texts.of(Language.class);
    private static final String KEY = "window.language";
    private static final Locale OF_SYSTEM = Locale.getDefault();

    private final String tag;
    private final String name;

    Language(String tag, String name) {
        this.tag = tag;
        this.name = name;
    }

    /** Returns the language that was chosen last. */
    static Language chosen(Settings settings) {
        Optional<String> kept = settings.get(KEY);
        return kept.isEmpty() ? SYSTEM : tagged(kept.get());
    }

    /** Returns the language with a tag; that of the computer if there are no texts in it. */
    private static Language tagged(String tag) {
        for (Language language : values()) {
            if (language.tag.equals(tag)) {
                return language;
            }
        }
        return SYSTEM;
    }

    /** Uses the language that was chosen last; must be called before a window reads a text. */
    static void install(Settings settings) {
        use(chosen(settings).locale());
    }

    /** Lets windows, and Swing's own dialogs, read their texts in a language. */
    static void use(Locale language) {
        if (!language.equals(Locale.getDefault())) {
            Locale.setDefault(language);
            JComponent.setDefaultLocale(language);
            UIManager.getDefaults().setDefaultLocale(language);
            UIManager.getLookAndFeelDefaults().setDefaultLocale(language);
        }
    }

    /**
     * Stores this language for the next start.
     *
     * @return whether it differs from the present language
     */
    boolean choose(Settings settings) {
        BackgroundSettings.put(settings, KEY, tag);
        return !locale().equals(Locale.getDefault());
    }

    /** Keeps the country of the computer if the language is the computer's. */
    private Locale locale() {
        String system = OF_SYSTEM.getLanguage();
        if (this == SYSTEM) {
            return tagged(system) == SYSTEM ? Locale.ENGLISH : OF_SYSTEM;
        }
        return tag.equals(system) ? OF_SYSTEM : Locale.forLanguageTag(tag);
    }

    /** Returns its name in the menu. */
    @Override
    public String toString() {
        return TEXTS.get(name);
    }
}
