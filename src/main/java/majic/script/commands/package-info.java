/**
 * The commands of MAJIC Script: what each states about itself, how it is parsed, checked and run, and what {@code help}
 * answers about it.
 */
@NullMarked
package majic.script.commands;

import org.jspecify.annotations.NullMarked;
