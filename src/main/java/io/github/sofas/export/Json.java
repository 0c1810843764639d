package io.github.sofas.export;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.core.util.JsonGeneratorDelegate;
import java.io.IOException;
import java.io.OutputStream;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Map;

/** JSON as this program writes it: UTF-8, indented by two, LF on every system, decimals instead of exponents. */
public final class Json {
    private static final JsonFactory FACTORY = new JsonFactory();

    private Json() {
    }

    /**
     * Starts a document that ends in a line feed.
     *
     * @param out left open when the generator is closed
     * @return the document
     * @throws IOException if the document cannot be written
     */
    public static JsonGenerator open(OutputStream out) throws IOException {
        DefaultIndenter indenter = new DefaultIndenter("  ", "\n");
        DefaultPrettyPrinter printer = new DefaultPrettyPrinter().withObjectIndenter(indenter)
            .withArrayIndenter(indenter);
        JsonGenerator json = FACTORY.createGenerator(out).setPrettyPrinter(printer)
            .disable(JsonGenerator.Feature.AUTO_CLOSE_TARGET);
        return new JsonGeneratorDelegate(json) {
            @Override
            public void close() throws IOException {
                if (!isClosed()) {
                    writeRaw('\n');
                }
                super.close();
            }
        };
    }

    /**
     * Writes a number with a given number of decimals.
     *
     * @param json the document
     * @param name name of the value
     * @param value a finite number
     * @param decimals number of decimals
     * @throws IOException if the number cannot be written
     */
    public static void write(JsonGenerator json, String name, double value, int decimals) throws IOException {
        json.writeFieldName(name);
        // As text, because the generator would write a BigDecimal like 0.000000 as 0E-6.
        json.writeNumber(BigDecimal.valueOf(value).setScale(decimals, RoundingMode.HALF_UP).toPlainString());
    }

    /**
     * Writes a method's parameters as an object.
     *
     * @param json the document, where the object goes
     * @param parameters a Number, Boolean or String each, by the name of its option
     * @throws IOException if the parameters cannot be written
     */
    public static void writeParameters(JsonGenerator json, Map<String, Object> parameters) throws IOException {
        json.writeStartObject();
        for (Map.Entry<String, Object> parameter : parameters.entrySet()) {
            json.writeFieldName(parameter.getKey());
            Object value = parameter.getValue();
            if (value instanceof Number) {
                // The number's own text: 20 stays 20, 0.1f stays 0.1.
                json.writeNumber(value.toString());
            } else if (value instanceof Boolean) {
                json.writeBoolean((Boolean) value);
            } else {
                json.writeString(value.toString());
            }
        }
        json.writeEndObject();
    }
}
