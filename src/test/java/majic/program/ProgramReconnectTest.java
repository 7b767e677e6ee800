package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.OptionalInt;
import majic.bot.FakeBot;
import majic.time.TimeSource;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ProgramReconnectTest {
    @Test
    void aLostRobotIsConnectedAgainIfThatIsRequested(@TempDir Path folder) throws Exception {
        try (Program program = new Program(new UserFolder(folder), null, false)) {
            FakeBot bot = FakeBot.on(TimeSource.system());
            bot.connect();
            program.team().add(bot, OptionalInt.empty());
            program.reconnectLost();
            bot.cut();
            assertThat(program.team().changes().await(bot::isConnected, 100)).isTrue();
        }
    }
}
