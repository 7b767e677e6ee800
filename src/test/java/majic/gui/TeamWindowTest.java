package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import javax.swing.JTabbedPane;
import majic.bot.ConnectFailed;
import majic.bot.Pose;
import majic.gui.map.TeamMap;
import majic.team.Member;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class TeamWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    @Test
    void killBotClosesTheRobotAndItsTabAndReportsIt() {
        ToyBot bot = window.add("one");
        window.click("Kill Bot");
        window.click("OK");
        window.awaitMessage("Bot 1 is dead");
        window.await("the tab to go", () -> window.tabs().isEmpty());
        assertThat(bot.told).contains("shut");
    }

    @Test
    void aRobotsTabShowsItsNumberAndItsType() {
        window.add("one");
        assertThat(window.tabs()).containsExactly("1");
        assertThat(window.text("tabName1")).isEqualTo("Toy");
        assertThat(window.find("mainPane", JTabbedPane.class).getToolTipTextAt(0))
                .startsWith("Playthings Toy: robot 1 ");
        assertThat(window.frame.totalBots()).isEqualTo(1);
        assertThat(window.frame.getBot(1)).isSameAs(window.type.made.get(0));
    }

    @Test
    void aRobotsPanelShowsItsPoseAndItsState() {
        window.add("one").at(new Pose(120, -30, 45), true);
        window.await("its place", () -> window.text("pose1").equals("x 120 mm   y −30 mm   heading 45°"));
        assertThat(window.text("condition1")).isEqualTo("connected, moving");
    }

    @Test
    void aPlaceJustBelowZeroIsShownAsZero() {
        window.add("one").at(new Pose(-0.4, -0.2, -0.3), true);
        window.await("its place", () -> window.text("condition1").equals("connected, moving"));
        assertThat(window.text("pose1")).isEqualTo("x 0 mm   y 0 mm   heading 0°");
    }

    @Test
    void aRobotWithoutDisplayHasAPanelThatStatesIt() {
        window.add("plain");
        window.await("the words", () -> window.isShowing("noDisplay"));
    }

    @Test
    void aRobotWhoseDisplayLacksAClassHasAPanelThatStatesIt() {
        window.add("incomplete");
        window.await("the words", () -> window.isShowing("noDisplay"));
    }

    @Test
    void aLostRobotCanBeConnectedAgain() {
        ToyBot bot = window.add("one");
        bot.loseLink();
        window.awaitMessage("1: connection lost: the cable is out");
        window.click("reconnect1");
        window.await("the link", bot::isConnected);
        window.await("the button to go", () -> !window.isShowing("reconnect1"));
    }

    @Test
    void afterReconnectOneCanTypeCommands() {
        ToyBot bot = window.add("one");
        bot.loseLink();
        window.click("reconnect1");
        window.await("the button to go", () -> !window.isShowing("reconnect1"));
        window.type("1 move 50");
        assertThat(window.text("commandLine")).isEqualTo("1 move 50");
    }

    @Test
    void killBotWithoutRobotsReportsThatThereAreNone() {
        window.click("Kill Bot");
        window.awaitMessage("There are no robots yet");
    }

    @Test
    void closingTheWindowQuitsOnce() {
        window.run(window.frame::quit);
        window.run(window.frame::quit);
        window.await("the end", () -> window.quits.get() == 1);
    }

    @Test
    void theMapShowsTheTeam() {
        window.add("one");
        TeamMap map = window.find("teamMap", TeamMap.class);
        window.await(
                "a robot on the map",
                () -> String.valueOf(map.getAccessibleContext().getAccessibleDescription())
                        .startsWith("1 "));
    }

    @Test
    void thePanesReachTheBottomOfTheWindow() {
        window.add("one");
        Container content = window.frame.getContentPane();
        Component panes = content.getComponent(content.getComponentCount() - 1);
        window.await(
                "a layout",
                () -> content.getHeight() > 0 && content.getHeight() - panes.getY() - panes.getHeight() < 10);
    }

    @Test
    void anotherAdapterIsConnectedAfterAQuestionOnly() {
        window.command("add toy:one");
        window.await("the tab", () -> window.tabs().contains("1"));
        ToyBot bot = (ToyBot) window.team.member(1).bot();
        bot.refuseConnections(
                new ConnectFailed(ConnectFailed.Reason.OTHER_ADAPTER, "ttyUSB0 is another adapter now; add it"));
        bot.loseLink();
        window.await("the button", () -> window.isShowing("tabReconnect1"));
        window.click("tabReconnect1");
        window.await("the question", () -> window.isShowing("Connect"));
        assertThat(window.team.members()).extracting(Member::bot).containsExactly(bot);

        window.click("Connect");

        window.await(
                "another connection",
                () -> window.team.members().stream()
                        .anyMatch(member -> member.bot() != bot && member.bot().isConnected()));
        assertThat(window.team.member(1).bot()).isNotSameAs(bot);
    }
}
