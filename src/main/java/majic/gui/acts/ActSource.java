package majic.gui.acts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.act.ActDetails;
import majic.act.file.ActCatalog;
import majic.act.make.ActMaker;
import majic.bot.BotException;
import majic.file.WholeFile;
import majic.script.ScriptAct;
import majic.text.IoReason;
import majic.text.Texts;

/**
 * A source from which an act's file can be made: compiled classes, a jar, a source file, or a script. Its methods may
 * block.
 */
final class ActSource {
    private static final Texts TEXTS = Texts.of(ActSource.class);
    /** Makes the file of one of the source's acts. */
    private interface Making {
        byte[] make(String act, ActDetails details);
    }

    private final List<String> acts;
    private final Making making;

    private ActSource(List<String> acts, Making making) {
        this.acts = acts;
        this.making = making;
    }

    /**
     * Reads the source; a Java source file is compiled.
     *
     * @throws BotException if there is no act in it, saying why
     */
    static ActSource read(Path path) {
        if (path.toString().endsWith(ScriptAct.ENDING)) {
            ScriptAct script = ScriptAct.read(path);
            String name = String.valueOf(path.getFileName()).replace(ScriptAct.ENDING, "");
            return new ActSource(List.of(name), (act, details) -> ActMaker.save(script, details));
        }
        ActMaker maker = ActMaker.from(path);
        List<String> acts = maker.acts();
        return new ActSource(acts.isEmpty() ? List.of(maker.onlyAct()) : acts, maker::make);
    }

    /** Returns the classes of its acts, or the script's name; at least one. */
    List<String> acts() {
        return acts;
    }

    /**
     * Makes the file, which for Java runs the constructor of the class once.
     *
     * @return what was done, in a sentence
     * @throws BotException if the act is not suitable, or the file cannot be written
     */
    String make(String act, ActDetails details, Path target) {
        if (!target.toString().endsWith(ActCatalog.ENDING)) {
            throw new BotException(TEXTS.get("ending", target, ActCatalog.ENDING));
        }
        byte[] file = making.make(act, details);
        try {
            Path folder = target.toAbsolutePath().getParent();
            if (folder != null) {
                Files.createDirectories(folder);
            }
            WholeFile.replace(target, file);
        } catch (IOException e) {
            throw new BotException(TEXTS.get("notWritten", target, IoReason.of(e)), e);
        }
        return TEXTS.get("made", target, file.length);
    }

    /** Returns the last part of a class's name, which is the act's name unless another one is given. */
    static String simpleName(String act) {
        return act.substring(Math.max(act.lastIndexOf('.'), act.lastIndexOf('$')) + 1);
    }
}
