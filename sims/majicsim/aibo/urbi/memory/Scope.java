package majicsim.aibo.urbi.memory;

import org.jspecify.annotations.Nullable;

/**
 * The scope in which a name is looked up first. Immutable.
 *
 * @param connectionId the connection to which bare names belong
 * @param frame the call that runs, with its local variables; null outside of one
 */
public record Scope(String connectionId, @Nullable Frame frame) {}
