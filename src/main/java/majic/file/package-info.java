/**
 * Files on this computer: reading regular files only, replacing a file as a whole, keeping a damaged file under another
 * name, the private folder of native code.
 */
@NullMarked
package majic.file;

import org.jspecify.annotations.NullMarked;
