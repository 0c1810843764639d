package io.github.sofas;

import static org.junit.Assert.assertEquals;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.io.IOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.RecordComponent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.Test;

/**
 * Holds what others may call: every public type of the packages that are documented for them, with its public and
 * protected members, as {@code config/api.txt} lists them. A change of that list is a change of the public API.
 */
public class ApiTest {
    private static final Path LIST = Path.of("config", "api.txt");
    private static final Path NOW = Path.of("build", "api.txt");

    /** Packages inside {@code flow} and those of the program itself are public only for each other. */
    private static final List<String> PACKAGES = List.of("event", "flow", "recording", "live", "export", "render",
        "baseline", "simulate", "evaluate");

    @Test
    public void thePublicApiIsTheOneListed() throws IOException {
        List<String> now = signatures();
        Files.createDirectories(NOW.getParent());
        Files.write(NOW, now);
        Set<String> added = new TreeSet<>(now);
        Set<String> removed = new TreeSet<>(Files.readAllLines(LIST));
        Set<String> before = Set.copyOf(removed);
        removed.removeAll(added);
        added.removeAll(before);
        assertEquals("public API: removed " + removed + ", added " + added + "; if that is meant, copy " + NOW + " to "
            + LIST + " and say so in CHANGELOG.md", Files.readAllLines(LIST), now);
    }

    private static List<String> signatures() {
        Set<String> lines = new TreeSet<>();
        for (String name : PACKAGES) {
            for (JavaClass type : new ClassFileImporter()
                    .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                    .importPackages("io.github.sofas." + name)) {
                // not those of packages inside
                if (type.getPackageName().equals("io.github.sofas." + name) && isPublic(type.reflect())) {
                    add(type.reflect(), lines);
                }
            }
        }
        return lines.stream().map(ApiTest::shortened).toList();
    }

    private static String shortened(String line) {
        return line.replace("io.github.sofas.", "").replaceAll("java\\.(lang|util|util\\.function)\\.(?=[A-Z])", "")
            .replace('$', '.');
    }

    private static boolean isPublic(Class<?> type) {
        for (Class<?> each = type; each != null; each = each.getEnclosingClass()) {
            if (!isShown(each.getModifiers())) {
                return false;
            }
        }
        return !type.isAnonymousClass() && !type.isLocalClass();
    }

    private static boolean isShown(int modifiers) {
        return Modifier.isPublic(modifiers) || Modifier.isProtected(modifiers);
    }

    private static void add(Class<?> type, Set<String> lines) {
        String name = type.getName().substring("io.github.sofas.".length()).replace('$', '.');
        String kind = type.isRecord() ? "record" : type.isEnum() ? "enum" : type.isAnnotation() ? "annotation"
            : type.isInterface() ? "interface" : Modifier.isAbstract(type.getModifiers()) ? "abstract class"
            : Modifier.isFinal(type.getModifiers()) ? "final class" : "class";
        String components = !type.isRecord() ? "" : Arrays.stream(type.getRecordComponents())
            .map(ApiTest::component).collect(Collectors.joining(", ", "(", ")"));
        String parents = Stream.concat(Stream.ofNullable(type.getSuperclass()), Arrays.stream(type.getInterfaces()))
            .filter(parent -> !Set.of("Object", "Record", "Enum", "Annotation").contains(parent.getSimpleName()))
            .map(Class::getSimpleName).collect(Collectors.joining(", "));
        lines.add(name + ": " + kind + components + (parents.isEmpty() ? "" : " of " + parents));
        List<String> accessors = new ArrayList<>(List.of("equals", "hashCode", "toString"));
        if (type.isRecord()) {
            Arrays.stream(type.getRecordComponents()).map(RecordComponent::getName).forEach(accessors::add);
        } else if (type.isEnum()) {
            accessors.addAll(List.of("values", "valueOf"));
        }
        for (Field field : type.getDeclaredFields()) {
            if (isShown(field.getModifiers()) && !field.isSynthetic()) {
                lines.add(name + "." + field.getName() + ": " + (field.isEnumConstant() ? "constant"
                    : isStatic(field.getModifiers()) + field.getGenericType().getTypeName()));
            }
        }
        for (Constructor<?> constructor : type.getDeclaredConstructors()) {
            if (isShown(constructor.getModifiers()) && !constructor.isSynthetic() && !type.isRecord()) {
                lines.add(name + parameters(constructor));
            }
        }
        for (Method method : type.getDeclaredMethods()) {
            if (isShown(method.getModifiers()) && !method.isSynthetic() && !accessors.contains(method.getName())) {
                lines.add(name + "." + method.getName() + parameters(method) + ": " + isStatic(method.getModifiers())
                    + method.getGenericReturnType().getTypeName());
            }
        }
    }

    private static String component(RecordComponent component) {
        return component.getGenericType().getTypeName() + " " + component.getName();
    }

    private static String isStatic(int modifiers) {
        return Modifier.isStatic(modifiers) ? "static " : "";
    }

    private static String parameters(Executable executable) {
        return Arrays.stream(executable.getGenericParameterTypes()).map(type -> type.getTypeName())
            .collect(Collectors.joining(", ", "(", ")")) + Arrays.stream(executable.getExceptionTypes())
            .map(Class::getSimpleName).sorted().collect(Collectors.joining(", ",
                executable.getExceptionTypes().length == 0 ? "" : " throws ", ""));
    }
}
