package majic.build;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;

/**
 * A Maven project file.
 *
 * @param file where it is
 * @param project its root element
 */
record Pom(Path file, Element project) {
    static Pom read(Path file) {
        try {
            return new Pom(
                    file,
                    DocumentBuilderFactory.newInstance()
                            .newDocumentBuilder()
                            .parse(file.toFile())
                            .getDocumentElement());
        } catch (ParserConfigurationException | SAXException | IOException e) {
            throw new IllegalStateException(file + " cannot be read", e);
        }
    }

    /** Returns the child elements of a name. */
    static Stream<Element> children(Element parent, String name) {
        NodeList nodes = parent.getChildNodes();
        return IntStream.range(0, nodes.getLength())
                .mapToObj(nodes::item)
                .filter(node -> node.getNodeType() == Node.ELEMENT_NODE
                        && node.getNodeName().equals(name))
                .map(Element.class::cast);
    }

    /** Returns the text of the first child element of a name; empty if there is none. */
    static String text(Element parent, String name) {
        return children(parent, name)
                .findFirst()
                .map(child -> child.getTextContent().strip())
                .orElse("");
    }

    /** Returns all elements of a name, at any depth. */
    List<Element> all(String name) {
        NodeList found = project.getElementsByTagName(name);
        return IntStream.range(0, found.getLength())
                .mapToObj(index -> (Element) found.item(index))
                .toList();
    }

    /** Returns the direct dependencies that the project needs to run; its own optional ones only if they are wanted. */
    Stream<Element> dependencies(boolean optional) {
        return children(project, "dependencies")
                .flatMap(list -> children(list, "dependency"))
                .filter(one -> !List.of("test", "provided").contains(text(one, "scope")))
                .filter(one -> optional || !text(one, "optional").equals("true"));
    }

    /**
     * Returns whether a dependency without a scope of its own has one of a parent's, by which it is for tests alone.
     */
    boolean isManagedForTests(Element dependency, Path repository) {
        return text(dependency, "scope").isEmpty()
                && parent(repository)
                        .filter(parent ->
                                parent.manages(dependency) || parent.isManagedForTests(dependency, repository))
                        .isPresent();
    }

    private boolean manages(Element dependency) {
        return children(project, "dependencyManagement")
                .flatMap(management -> children(management, "dependencies"))
                .flatMap(list -> children(list, "dependency"))
                .filter(one -> text(one, "artifactId").equals(text(dependency, "artifactId")))
                .anyMatch(one -> text(one, "scope").equals("test"));
    }

    /** Returns the names of the licences, of the project or else of its parent. */
    List<String> licences(Path repository) {
        List<String> own = children(project, "licenses")
                .flatMap(list -> children(list, "license"))
                .map(licence -> text(licence, "name"))
                .toList();
        return own.isEmpty()
                ? parent(repository).map(parent -> parent.licences(repository)).orElse(List.of())
                : own;
    }

    private Optional<Pom> parent(Path repository) {
        return children(project, "parent").findFirst().map(parent -> {
            String artifact = text(parent, "artifactId");
            String version = text(parent, "version");
            return read(repository
                    .resolve(text(parent, "groupId").replace('.', '/'))
                    .resolve(artifact)
                    .resolve(version)
                    .resolve(artifact + "-" + version + ".pom"));
        });
    }
}
