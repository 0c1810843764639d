package io.github.sofas.recording;

import static io.github.sofas.recording.Aedat4Format.HEADER;
import static io.github.sofas.recording.Aedat4Format.HEADER_COMPRESSION;
import static io.github.sofas.recording.Aedat4Format.HEADER_DATA_TABLE;
import static io.github.sofas.recording.Aedat4Format.HEADER_XML;
import static io.github.sofas.recording.Aedat4Format.INT;
import static io.github.sofas.recording.Aedat4Format.MAGIC_BYTES;
import static io.github.sofas.recording.Aedat4Format.MAX_HEADER_BYTES;

import io.github.sofas.recording.Aedat4Format.Compression;
import java.io.IOException;
import java.io.StringReader;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.xml.XMLConstants;
import javax.xml.parsers.DocumentBuilder;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.xml.sax.InputSource;
import org.xml.sax.SAXException;

/**
 * The header of an AEDAT 4.0 file. It precedes the packets and declares how they are packed and which streams they
 * belong to.
 *
 * @param compression how payloads are packed
 * @param dataTableAt where the data table starts; -1 where recording was cut short
 * @param streams the declared streams by id, in the order of the file
 */
record Aedat4Header(Compression compression, long dataTableAt, Map<Integer, Stream> streams) {

    /**
     * A declared stream.
     *
     * @param type its identifier, such as EVTS
     * @param source camera and serial number, or null
     * @param width columns as written; null where absent
     * @param height rows as written; null where absent
     */
    record Stream(String type, String source, String width, String height) {
        /** The camera's name, which precedes the serial number in the source; null where there is no source. */
        String chip() {
            return source == null || source.isBlank() ? null : source.replaceFirst("_.*", "");
        }
    }

    /** Greatest depth of the declarations' XML, because recursion walks it; recorders nest four levels deep. */
    private static final int MAX_DEPTH = 64;

    /** Reads the header and leaves the file at the first packet. */
    static Aedat4Header read(RecordingFile file) throws IOException, MalformedRecordingException {
        file.seek(MAGIC_BYTES);
        if (!file.require(4)) {
            throw bad(file, "truncated, the header's size must have 4 bytes but had " + file.available(), null);
        }
        long size = (int) INT.get(file.buffer, file.position) & 0xFFFFFFFFL;
        if (size > MAX_HEADER_BYTES) {
            throw bad(file, "malformed, the header must have at most " + MAX_HEADER_BYTES + " bytes but had " + size,
                    null);
        }
        file.position += 4;
        byte[] bytes = new byte[(int) Math.min(size, Math.max(0, file.size() - file.offset()))];
        int have = file.read(bytes, 0, bytes.length);
        if (have < size) {
            throw bad(file, "truncated, the header must have " + size + " bytes but had " + have, null);
        }
        if (!FlatTable.hasIdentifier(bytes, 4, have, HEADER)) {
            throw bad(file, "malformed, the header must have the identifier " + HEADER + " but had another", null);
        }
        int code;
        long dataTableAt;
        String xml;
        try {
            FlatTable table = FlatTable.root(bytes, 0, have);
            code = table.intField(HEADER_COMPRESSION, 0);
            dataTableAt = table.longField(HEADER_DATA_TABLE, -1);
            xml = table.text(HEADER_XML);
        } catch (IndexOutOfBoundsException e) {
            throw bad(file, "malformed, the header's table must lie within its " + have + " bytes but points outside",
                    e);
        }
        if (code < 0 || code >= Compression.values().length) {
            throw bad(file, "unsupported, the compression must be between 0 and " + (Compression.values().length - 1)
                    + " but was " + code, null);
        }
        return new Aedat4Header(Compression.values()[code], dataTableAt, streams(file, xml == null ? "" : xml));
    }

    private static Map<Integer, Stream> streams(RecordingFile file, String xml)
            throws IOException, MalformedRecordingException {
        Map<Integer, Stream> streams = new LinkedHashMap<>();
        Element root;
        try {
            DocumentBuilderFactory factory = DocumentBuilderFactory.newDefaultInstance();
            factory.setAttribute("jdk.xml.maxElementDepth", MAX_DEPTH);
            factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
            factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
            factory.setXIncludeAware(false);
            factory.setExpandEntityReferences(false);
            DocumentBuilder builder = factory.newDocumentBuilder();
            // The default handler prints to stderr.
            builder.setErrorHandler(null);
            root = builder.parse(new InputSource(new StringReader(xml))).getDocumentElement();
        } catch (SAXException e) {
            throw bad(file, "malformed, the streams must be declared in XML without a document type but were not: "
                    + Printable.shortened(e.getMessage()), e);
        } catch (ParserConfigurationException e) {
            throw new IllegalStateException("the JDK's XML parser has no secure processing", e);
        }
        Element declarations = find(root, "outInfo");
        for (Node node = declarations == null ? null : declarations.getFirstChild(); node != null;
                node = node.getNextSibling()) {
            if (node instanceof Element stream && stream.getTagName().equals("node")) {
                Element info = find(stream, "info");
                try {
                    streams.put(Integer.valueOf(stream.getAttribute("name")),
                            new Stream(attribute(stream, "typeIdentifier"), attribute(info, "source"),
                                    attribute(info, "sizeX"), attribute(info, "sizeY")));
                } catch (NumberFormatException e) {
                    throw bad(file, "malformed, a stream's name must be a number but was \""
                            + Printable.shortened(stream.getAttribute("name")) + "\"", e);
                }
            }
        }
        return streams;
    }

    /** The first node with a name, at any depth, in the order of the text. */
    private static Element find(Element parent, String name) {
        for (Node child = parent.getFirstChild(); child != null; child = child.getNextSibling()) {
            if (child instanceof Element element && element.getTagName().equals("node")) {
                if (element.getAttribute("name").equals(name)) {
                    return element;
                }
                Element found = find(element, name);
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }

    /** The text of a node's own attribute; null where node or attribute is absent. */
    private static String attribute(Element node, String key) {
        for (Node child = node == null ? null : node.getFirstChild(); child != null; child = child.getNextSibling()) {
            if (child instanceof Element element && element.getTagName().equals("attr")
                    && element.getAttribute("key").equals(key)) {
                return Printable.shortened(element.getTextContent().strip());
            }
        }
        return null;
    }

    private static MalformedRecordingException bad(RecordingFile file, String rule, Throwable cause) {
        return new MalformedRecordingException("[" + file.name + "] header at byte " + MAGIC_BYTES + ": " + rule,
                cause);
    }
}
