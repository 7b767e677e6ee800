/** The parameters of a Hemisson besides those that every robot has and those of its modules. */
@NullMarked
package majic.hemisson.parameters;

import org.jspecify.annotations.NullMarked;
