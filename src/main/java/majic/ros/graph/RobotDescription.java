package majic.ros.graph;

import java.io.StringReader;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import majic.bot.BotException;

/**
 * The description of a robot's body in the format URDF: it states which joints slide; messages about joints do not. A
 * robot with joints usually keeps it in a parameter {@code robot_description}.
 */
public final class RobotDescription {
    private static final Logger LOG = System.getLogger(RobotDescription.class.getName());
    private static final String PARAMETER = "robot_description";

    private RobotDescription() {}

    /**
     * Asks for the description, and returns the joints that slide.
     *
     * @param api of the robot
     * @param graph its nodes
     * @param namespace of the robot, as {@code /robot1}; empty for a robot without
     * @return their names; none if there is no description
     * @throws BotException if the connection is lost
     */
    public static Set<String> slidingJoints(RosApi api, RosGraph graph, String namespace) {
        return parameters(graph, namespace).stream()
                .map(api::textParameter)
                .flatMap(Optional::stream)
                .findFirst()
                .map(RobotDescription::slidingJoints)
                .orElse(Set.of());
    }

    /** In ROS 2 a parameter belongs to a node, and rosapi waits long for a node that is not there. */
    private static List<String> parameters(RosGraph graph, String namespace) {
        if (!graph.isRos2()) {
            return namespace.isEmpty()
                    ? List.of("/" + PARAMETER)
                    : List.of(namespace + "/" + PARAMETER, "/" + PARAMETER);
        }
        String node = namespace + "/robot_state_publisher";
        return graph.nodes().contains(node) ? List.of(node + ":" + PARAMETER) : List.of();
    }

    /** Returns the names of the joints that slide; those in front of a mistake if it is no XML. */
    static Set<String> slidingJoints(String urdf) {
        Set<String> sliding = new HashSet<>();
        try {
            XMLStreamReader xml = safeFactory().createXMLStreamReader(new StringReader(urdf));
            while (xml.hasNext()) {
                if (xml.next() == XMLStreamConstants.START_ELEMENT
                        && xml.getLocalName().equals("joint")
                        && "prismatic".equals(xml.getAttributeValue(null, "type"))) {
                    sliding.add(String.valueOf(xml.getAttributeValue(null, "name")));
                }
            }
        } catch (XMLStreamException e) {
            LOG.log(Level.DEBUG, "the description of the robot is no XML", e);
        }
        return sliding;
    }

    /** A description comes from the network: it must not make this program read files or addresses. */
    private static XMLInputFactory safeFactory() {
        XMLInputFactory factory = XMLInputFactory.newInstance();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        return factory;
    }
}
