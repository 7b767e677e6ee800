/**
 * What desks send to each other through a broker: the topics, and the messages with their JSON. Knows no connection and
 * no robot. Uses Jackson, so only programs that share robots load it.
 */
@NullMarked
package majic.shared.message;

import org.jspecify.annotations.NullMarked;
