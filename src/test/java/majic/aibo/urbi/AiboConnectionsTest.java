package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import majic.aibo.AiboType;
import majic.aibo.ScriptedDog;
import majic.bot.BotException;
import majic.driver.RobotWait;
import majic.link.Links;
import org.junit.jupiter.api.Test;

class AiboConnectionsTest {
    @Test
    void whatIsClosedWhileItConnectsConnectsNoFurther() throws IOException {
        try (ScriptedDog dog = new ScriptedDog()) {
            RobotWait waiting = dog.waiting();
            AiboConnections connections = new AiboConnections(
                    () -> new LinkTransport(Links.of(dog.address(), AiboType.PORT, 0), waiting.time()),
                    waiting,
                    said -> {},
                    lost -> {});

            connections.close("stop walk;");

            assertThatThrownBy(connections::open).isInstanceOf(BotException.class);
            assertThat(dog.received()).isEmpty();
        }
    }
}
