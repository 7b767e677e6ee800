package majic.script.run;

import java.util.List;
import java.util.Optional;

/** What a command states about itself, whatever robots there are. */
public interface Instruction {
    /** When it runs, seen from the lines before and behind it. */
    Scheduling scheduling();

    /** What has to be known of it before it runs; nothing unless overridden. */
    default List<CommandTrait> traits() {
        return List.of();
    }

    default boolean has(CommandTrait trait) {
        return traits().contains(trait);
    }

    /** Why no behaviour may contain it, as half a sentence; empty if one may. */
    Optional<String> refusalInAct();
}
