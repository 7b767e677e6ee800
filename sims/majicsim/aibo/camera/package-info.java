/** The dog's camera: from what is visible to the bytes of a picture. */
@NullMarked
package majicsim.aibo.camera;

import org.jspecify.annotations.NullMarked;
