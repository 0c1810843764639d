package io.github.sofas.jaer;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.Test;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldNode;
import org.objectweb.asm.tree.MethodNode;

/** Holds the signatures that the filter compiles against to the real jAER: -PjaerHome=DIR. */
public class DeclarationsTest {
    private static final int SEEN = Opcodes.ACC_PUBLIC | Opcodes.ACC_PROTECTED | Opcodes.ACC_STATIC;

    private static Path folder(String property) {
        return Path.of(System.getProperty(property));
    }

    private static URLClassLoader jaer() throws IOException {
        String classPath = System.getProperty("sofas.jaer.classPath");
        if (classPath == null) {
            throw Skipped.because("no jAER to compare with; -PjaerHome=DIR names one");
        }
        List<URL> urls = new ArrayList<>();
        for (String entry : classPath.split(File.pathSeparator)) {
            urls.add(Path.of(entry).toUri().toURL());
        }
        return new URLClassLoader(urls.toArray(new URL[0]), null);
    }

    private static ClassNode parse(InputStream in) throws IOException {
        ClassNode node = new ClassNode();
        new ClassReader(in).accept(node, ClassReader.SKIP_CODE);
        return node;
    }

    /** A class of jAER and all that it inherits from. */
    private static List<ClassNode> family(URLClassLoader jaer, String name) throws IOException {
        List<ClassNode> family = new ArrayList<>();
        try (InputStream in = jaer.getResourceAsStream(name + ".class")) {
            if (in == null) {
                return family;
            }
            ClassNode node = parse(in);
            family.add(node);
            if (node.superName != null) {
                family.addAll(family(jaer, node.superName));
            }
            for (String parent : node.interfaces) {
                family.addAll(family(jaer, parent));
            }
        }
        return family;
    }

    @Test
    public void everyDeclaredMemberIsInJaer() throws IOException {
        List<String> missing = new ArrayList<>();
        try (URLClassLoader jaer = jaer(); Stream<Path> files = Files.walk(folder("sofas.jaer.declarations"))) {
            for (Path file : files.filter(path -> path.toString().endsWith(".class")).toList()) {
                ClassNode declared;
                try (InputStream in = Files.newInputStream(file)) {
                    declared = parse(in);
                }
                List<ClassNode> real = family(jaer, declared.name);
                if (real.isEmpty()) {
                    missing.add(declared.name);
                    continue;
                }
                if (real.stream().noneMatch(node -> node.name.equals(declared.superName))
                        && !declared.superName.equals("java/lang/Object")) {
                    missing.add(declared.name + " extends " + declared.superName);
                }
                for (FieldNode field : declared.fields) {
                    if (!isImplicit(field.access) && real.stream().noneMatch(node -> has(node, field))) {
                        missing.add(declared.name + "." + field.name + " " + field.desc);
                    }
                }
                for (MethodNode method : declared.methods) {
                    if (!isImplicit(method.access) && !method.name.startsWith("<")
                            && real.stream().noneMatch(node -> has(node, method))) {
                        missing.add(declared.name + "." + method.name + method.desc);
                    }
                }
            }
        }
        assertEquals("declared, but not so in jAER", List.of(), missing);
    }

    private static boolean has(ClassNode node, FieldNode field) {
        return node.fields.stream().anyMatch(other -> other.name.equals(field.name) && other.desc.equals(field.desc)
            && (other.access & SEEN) == (field.access & SEEN)
            && (field.value == null || field.value.equals(other.value)));
    }

    private static boolean has(ClassNode node, MethodNode method) {
        return node.methods.stream().anyMatch(other -> other.name.equals(method.name)
            && other.desc.equals(method.desc) && (other.access & SEEN) == (method.access & SEEN));
    }

    private static boolean isImplicit(int access) {
        return (access & (Opcodes.ACC_SYNTHETIC | Opcodes.ACC_PRIVATE)) != 0;
    }

    @Test
    public void bothWaysOfCompilingGiveTheSameClasses() throws IOException {
        jaer().close();
        int compared = 0;
        Path main = Path.of(SofasFlow.class.getProtectionDomain().getCodeSource().getLocation().getPath());
        Path other = folder("sofas.jaer.againstDeclarations");
        try (Stream<Path> files = Files.walk(main)) {
            for (Path file : files.filter(path -> path.toString().endsWith(".class")).toList()) {
                assertArrayEquals(file.toString(), Files.readAllBytes(file),
                    Files.readAllBytes(other.resolve(main.relativize(file))));
                compared++;
            }
        }
        assertTrue("classes " + compared, compared > 8);
    }
}
