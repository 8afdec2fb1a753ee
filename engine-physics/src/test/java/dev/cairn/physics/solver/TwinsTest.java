package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.lang.classfile.ClassFile;
import java.lang.classfile.ClassModel;
import java.lang.classfile.CodeElement;
import java.lang.classfile.Instruction;
import java.lang.classfile.MethodModel;
import java.lang.classfile.Opcode;
import java.lang.classfile.instruction.InvokeInstruction;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * The kernels in single precision compute in single precision: what {@code build/Twins.java} made
 * of a kernel reads doubles, or computes with what it reads, only to round the result at once; it
 * never compares or keeps one. Java would widen a float to a double without a word where a {@code
 * double} was missed.
 */
final class TwinsTest {
    @Test
    void noTwinComputesInDoubles() throws Exception {
        List<String> found = new ArrayList<>();
        int twins = 0;
        URI here = ContactSolver.class.getProtectionDomain().getCodeSource().getLocation().toURI();
        for (Path file : classes(Path.of(here))) {
            ClassModel type = ClassFile.of().parse(file);
            twins++;
            for (MethodModel method : type.methods()) {
                String where = file.getFileName() + " " + method.methodName();
                method.code().ifPresent(code -> look(code.elementList(), where, found));
            }
        }
        assertTrue(twins >= 21, twins + " twins");
        assertEquals(List.of(), found);
    }

    private static void look(List<CodeElement> code, String where, List<String> found) {
        boolean pending = false;
        for (CodeElement element : code) {
            if (element instanceof Instruction one) {
                if (pending && one.opcode() != Opcode.D2F) {
                    found.add(where + ": a double before " + one);
                }
                pending = isDouble(one);
            }
        }
    }

    private static List<Path> classes(Path root) throws IOException {
        try (Stream<Path> files = Files.walk(root)) {
            return files.filter(file -> file.getFileName().toString().matches("Single.*\\.class"))
                    .filter(file -> !file.getFileName().toString().startsWith("SingleContact"))
                    .toList();
        }
    }

    /** Whether an instruction computes with a double, or keeps one in a variable. */
    private static boolean isDouble(Instruction one) {
        String name = one.opcode().name();
        return name.matches("D(ADD|SUB|MUL|DIV|REM|NEG|CMPL|CMPG|STORE.*)")
                || (one instanceof InvokeInstruction call
                        && call.owner().asInternalName().equals("java/lang/Math")
                        && !call.name().equalsString("sqrt")
                        && call.type().stringValue().contains("D"));
    }
}
