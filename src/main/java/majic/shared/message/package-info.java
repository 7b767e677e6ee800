/**
 * What desks send to each other through a broker: the topics, and the messages with their JSON. Contains nothing about
 * connections. Uses Jackson, so only programs that share robots load it.
 */
@NullMarked
package majic.shared.message;

import org.jspecify.annotations.NullMarked;
