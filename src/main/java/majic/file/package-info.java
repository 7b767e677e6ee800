/**
 * Files on this computer: reading regular files only, replacing a file as a whole, keeping a damaged file under another
 * name.
 */
@NullMarked
package majic.file;

import org.jspecify.annotations.NullMarked;
