/**
 * A program that sends very many commands to a team of simulated robots whose connections fail in every way that the
 * lab offers, and accounts for each command in the session log. See CONTRIBUTING.
 */
@NullMarked
package majic.soak;

import org.jspecify.annotations.NullMarked;
