/** The packets that a client receives: the standard packet (SIP) and those requested besides it. */
@NullMarked
package majicsim.pioneer.report;

import org.jspecify.annotations.NullMarked;
