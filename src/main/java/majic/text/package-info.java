/**
 * Texts for users: resource bundles, errors in the language of the window, reasons of failed input and output, advice
 * behind an error, the word that was probably meant, control characters made visible.
 */
@NullMarked
package majic.text;

import org.jspecify.annotations.NullMarked;
