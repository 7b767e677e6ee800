package majic.script.commands;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import majic.bot.BotAddress;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.bot.Value;
import majic.nav.CurrentMap;
import majic.script.record.SessionRecord;
import majic.script.run.RobotConnector;
import majic.script.run.SessionState;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;

/**
 * Writes the robots of a team as a script that adds them again: address and number, name, calibration, start pose. A
 * robot that was added without an address, by a program that embeds MAJIC, is left out.
 *
 * @param team the robots
 * @param factory has the names of those in the simulated lab, which are put down at their places again
 * @param connector has their addresses
 * @param map is opened again if it is in a file
 */
public record TeamScript(Team team, BotFactory factory, RobotConnector connector, CurrentMap map) {
    /** Parameters that are off at first. */
    private static final List<String> CHOICES = List.of("guard", "giveWay");

    /** Returns the script of a session. */
    public static TeamScript of(SessionState session) {
        return new TeamScript(session.team(), session.factory(), session.connector(), session.map());
    }

    /** Returns whether there is no robot to write. */
    public boolean isEmpty() {
        return team.members().stream()
                .allMatch(member -> connector.address(member).isEmpty());
    }

    /**
     * Returns the script.
     *
     * @return lines, each with a line end; a comment and nothing else for an empty team
     */
    public String text() {
        return text(member -> calibration(member) + start(member));
    }

    /**
     * Returns the script without the calibrations, for this computer, whose settings have them.
     *
     * @return as {@link #text()}
     */
    public String withoutCalibrations() {
        return text(this::start);
    }

    private String text(Function<Member, String> settings) {
        String robots = team.members().stream()
                .map(member -> add(member)
                        .map(add -> add + name(member) + settings.apply(member))
                        .orElse(""))
                .collect(Collectors.joining());
        String opened = map.file()
                .map(file -> "map open " + SessionRecord.quoted(file.toString()) + "\n")
                .orElse("");
        return "# " + team.listing() + "\n" + opened + robots;
    }

    private Optional<String> add(Member member) {
        return connector
                .address(member)
                .map(address -> "add " + SessionRecord.quoted(address) + " as " + member.number() + "\n");
    }

    private static String name(Member member) {
        return member.name().isEmpty() ? "" : member.number() + " name " + member.name() + "\n";
    }

    private static String calibration(Member member) {
        MajicBot bot = member.bot();
        return bot.calibration().stream()
                .flatMap(name -> written(bot.reading(name).last()).map(value -> set(member, name, value)).stream())
                .collect(Collectors.joining());
    }

    /** The place of a robot of another desk is kept there: setting it again would move it on the maps of all desks. */
    private String start(Member member) {
        if (connector
                .address(member)
                .map(BotAddress::parse)
                .filter(BotAddress::isOfAnotherDesk)
                .isPresent()) {
            return "";
        }
        String choices = CHOICES.stream()
                .filter(name -> member.bot().reading(name).last().isYes())
                .map(name -> set(member, name, "on"))
                .collect(Collectors.joining());
        boolean inLab = factory.nameInLab(member.bot()).isPresent();
        return choices
                + member.bot()
                        .placedAt()
                        .map(pose -> inLab
                                ? "lab place " + member.number() + " " + numbers(pose) + "\n"
                                : set(member, "pose", numbers(pose)))
                        .orElse("");
    }

    private static String numbers(Pose pose) {
        return List.of(pose.xMm(), pose.yMm(), pose.headingDeg()).stream()
                .map(TeamScript::plain)
                .collect(Collectors.joining(" "));
    }

    /** Writes a number with all digits that matter, as settings have them. */
    private static String plain(double number) {
        BigDecimal rounded = BigDecimal.valueOf(number).setScale(3, RoundingMode.HALF_UP);
        return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
    }

    private static String set(Member member, String name, String value) {
        return member.number() + " set " + name + " " + value + "\n";
    }

    /** Writes a value as {@code set} takes it; empty if there is none at the moment. */
    private static Optional<String> written(Value value) {
        if (value instanceof Value.Unknown) {
            return Optional.empty();
        }
        if (value instanceof Value.Many many) {
            return Optional.of(
                    many.values().stream().map(part -> plain(part.number())).collect(Collectors.joining(" ")));
        }
        return Optional.of(
                value instanceof Value.Number number
                        ? plain(number.amount()) + (number.unit() == Unit.MS ? Unit.MS.symbol() : "")
                        : SessionRecord.quoted(value.toString()));
    }
}
