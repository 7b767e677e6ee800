/** The modules that can be plugged into a Hemisson's extension connector, and raw access to their bus. */
@NullMarked
package majic.hemisson.modules;

import org.jspecify.annotations.NullMarked;
