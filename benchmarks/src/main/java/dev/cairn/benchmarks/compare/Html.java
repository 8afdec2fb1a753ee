package dev.cairn.benchmarks.compare;

import org.jspecify.annotations.Nullable;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import java.util.Locale;

/** Writes well-formed XHTML. One thread. */
final class Html {
    private final StringBuilder out = new StringBuilder();

    /** Adds markup as it is. */
    Html add(String markup) {
        out.append(markup);
        return this;
    }

    /** Adds text. */
    Html say(Object value) {
        out.append(text(value));
        return this;
    }

    /** Begins a table; names that begin with a blank head columns of text. */
    Html table(List<String> columns) {
        return table("", columns);
    }

    /** The same of a class of the style sheet. */
    Html table(String style, List<String> columns) {
        out.append("<div class=\"wide\"><table class=\"").append(style).append("\"><tr>");
        for (String column : columns) {
            boolean words = column.startsWith(" ");
            out.append(words ? "<th class=\"text\">" : "<th>").append(text(column.strip()));
            out.append("</th>");
        }
        out.append("</tr>\n");
        return this;
    }

    Html endTable() {
        out.append("</table></div>\n");
        return this;
    }

    Html words(Object value) {
        out.append("<td class=\"text\">").append(text(value)).append("</td>");
        return this;
    }

    Html cell(@Nullable Double value) {
        return cell(value == null ? "–" : number(value));
    }

    Html cell(String value) {
        out.append("<td>").append(text(value)).append("</td>");
        return this;
    }

    Html picture(String alt, String svg) {
        out.append("<div class=\"wide\"><img alt=\"")
                .append(text(alt))
                .append("\" src=\"data:image/svg+xml;base64,");
        out.append(Base64.getEncoder().encodeToString(svg.getBytes(StandardCharsets.UTF_8)));
        out.append("\"/></div>\n");
        return this;
    }

    @Override
    public String toString() {
        return out.toString();
    }

    /** Three digits, without an exponent where that is short. */
    static String number(double value) {
        if (Double.isNaN(value)) {
            return "–";
        }
        double size = Math.abs(value);
        if (size == 0) {
            return "0";
        }
        if (size >= 1e-3 && size < 1e5) {
            int digits = Math.clamp(2 - (int) Math.floor(StrictMath.log10(size)), 0, 5);
            return String.format(Locale.ROOT, "%." + digits + "f", value);
        }
        return String.format(Locale.ROOT, "%.2e", value).replaceFirst("e([+-])0", "e$1");
    }

    static String text(Object value) {
        return value.toString()
                .replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }
}
