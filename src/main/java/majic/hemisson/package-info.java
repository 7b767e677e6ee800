/**
 * K-Team's Hemisson: its line protocol (one question at a time over a serial line), its open-loop motion, its infra-red
 * senses and its panel.
 *
 * <p>Bytes come from {@link majic.link}, the contract from {@link majic.bot}; no other robot's package is known here.
 */
@NullMarked
package majic.hemisson;

import org.jspecify.annotations.NullMarked;
