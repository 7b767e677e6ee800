package majic.shared.desk;

import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import majic.bot.BotException;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.PublicationRefused;
import majic.shared.message.RequestReply;
import majic.shared.message.Sender;
import majic.shared.message.SiteTopics;
import majic.team.Team;

/**
 * What all parts of a sharing desk use. Immutable.
 *
 * @param team the robots of this program
 * @param self this desk
 * @param topics the topics of its site
 * @param connection with the broker
 * @param clock in which senders state how long something is valid
 * @param worker does what the thread of the connection must not wait for
 * @param map the map of this program
 * @param wake makes the timer of the desk look for work at once
 */
record DeskContext(
        Team team,
        Sender self,
        SiteTopics topics,
        BrokerConnection connection,
        DeskClock clock,
        DeskWorker worker,
        DeskMap map,
        Runnable wake) {

    /** Publishes a message if there is a connection; without one nothing is kept for later. */
    boolean publish(BrokerMessage message) {
        try {
            connection.publish(message);
            return true;
        } catch (BotException e) {
            return false;
        }
    }

    /**
     * Publishes a message as {@link #publish(BrokerMessage)}.
     *
     * @param refused receives the reason if the broker refuses it; must not wait
     */
    void publish(BrokerMessage message, Consumer<PublicationRefused> refused) {
        try {
            connection.publish(message, problem -> {
                if (problem instanceof PublicationRefused refusal) {
                    refused.accept(refusal);
                }
            });
        } catch (BotException e) {
            // Everything is published again with the next connection.
        }
    }

    /** Answers a message that asks for an answer below the site's topic for answers. */
    void reply(BrokerMessage to, RequestReply reply) {
        if (isAnswerable(to)) {
            publish(to.answer(reply.toJson(), BrokerMessage.JSON));
        }
    }

    /** Whether an answer has a place; other topics could make this desk command others in the sender's name. */
    boolean isAnswerable(BrokerMessage message) {
        return message.responseTopic() != null && message.responseTopic().startsWith(topics.replies(""));
    }

    /** Describes some robots by number. */
    static String listing(List<Integer> robots) {
        return robots.isEmpty()
                ? "it shares none"
                : robots.stream().map(String::valueOf).collect(Collectors.joining(", ", "it shares ", ""));
    }
}
