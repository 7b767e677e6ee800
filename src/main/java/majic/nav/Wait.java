package majic.nav;

import java.util.Optional;
import majic.bot.MajicBot;

/**
 * Why a robot stands on its way.
 *
 * @param why a part of a sentence such as {@code robot 2 (Pioneer) stands in the way}
 * @param other the robot that it waits for; empty if it is none or not known
 */
public record Wait(String why, Optional<MajicBot> other) {}
