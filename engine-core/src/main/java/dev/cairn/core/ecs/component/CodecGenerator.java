package dev.cairn.core.ecs.component;

import static java.lang.constant.ConstantDescs.CD_Object;
import static java.lang.constant.ConstantDescs.CD_double;
import static java.lang.constant.ConstantDescs.CD_float;
import static java.lang.constant.ConstantDescs.CD_int;
import static java.lang.constant.ConstantDescs.CD_long;
import static java.lang.constant.ConstantDescs.CD_void;
import static java.lang.constant.ConstantDescs.INIT_NAME;
import static java.lang.constant.ConstantDescs.MTD_void;
import static java.lang.invoke.MethodHandles.Lookup.ClassOption.NESTMATE;

import java.lang.classfile.ClassFile;
import java.lang.classfile.CodeBuilder;
import java.lang.constant.ClassDesc;
import java.lang.constant.MethodTypeDesc;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Modifier;
import java.lang.reflect.RecordComponent;

/**
 * Writes the class that moves one record type in and out of columns: straight-line code, one array
 * store per field, so that a spawn costs what hand-written code would. The class is hidden and a
 * nest mate of the record, so records of any visibility work, in any package. Where the record's
 * module is not open, it is a hidden class of this package instead, for public records only.
 */
final class CodecGenerator {
    private static final ClassDesc CODEC = RecordCodec.class.describeConstable().orElseThrow();
    private static final ClassDesc RECORD = Record.class.describeConstable().orElseThrow();
    private static final ClassDesc OBJECTS = CD_Object.arrayType();

    // Local variables of the two generated methods.
    private static final int VALUE = 1;
    private static final int WRITE_COLUMNS = 2;
    private static final int READ_COLUMNS = 1;
    private static final int TYPED = 5;

    private CodecGenerator() {}

    /** A codec beside the record; the lookup must have full privilege access to its class. */
    static RecordCodec generate(MethodHandles.Lookup lookup, Class<?> type)
            throws ReflectiveOperationException {
        String simple = type.getName().substring(type.getName().lastIndexOf('.') + 1);
        ClassDesc self = ClassDesc.of(type.getPackageName(), simple + "$$CairnCodec");
        return define(lookup.defineHiddenClass(bytes(self, type), true, NESTMATE));
    }

    /**
     * A codec in this package, for a record that {@link #isPublic} but whose package is not open.
     */
    static RecordCodec generateHere(Class<?> type) throws ReflectiveOperationException {
        ClassDesc self = ClassDesc.of(CodecGenerator.class.getPackageName(), "PublicCodec");
        return define(MethodHandles.lookup().defineHiddenClass(bytes(self, type), true));
    }

    /** Whether code of this package may name the record and the classes of its fields. */
    static boolean isPublic(Class<?> record) {
        boolean all = isNamed(record);
        for (RecordComponent field : record.getRecordComponents()) {
            all &= isNamed(field.getType());
        }
        return all;
    }

    private static boolean isNamed(Class<?> type) {
        if (type.isArray()) {
            return isNamed(type.getComponentType());
        }
        if (type.isPrimitive()) {
            return true;
        }
        Module own = CodecGenerator.class.getModule().addReads(type.getModule());
        return Modifier.isPublic(type.getModifiers())
                && type.getModule().isExported(type.getPackageName(), own)
                && isSeen(type);
    }

    @SuppressWarnings("ReferenceEquality") // two loaders may know different classes of one name
    private static boolean isSeen(Class<?> type) {
        try {
            ClassLoader own = CodecGenerator.class.getClassLoader();
            return Class.forName(type.getName(), false, own) == type;
        } catch (ClassNotFoundException unknown) {
            return false;
        }
    }

    /** Through the hidden class's own lookup: the class is not public, whatever its package. */
    private static RecordCodec define(MethodHandles.Lookup hidden)
            throws ReflectiveOperationException {
        MethodHandle constructor =
                hidden.findConstructor(hidden.lookupClass(), MethodType.methodType(void.class));
        try {
            return (RecordCodec) constructor.invoke();
        } catch (Throwable failure) {
            throw new InvocationTargetException(failure);
        }
    }

    private static byte[] bytes(ClassDesc self, Class<?> type) {
        RecordComponent[] fields = type.getRecordComponents();
        ClassDesc record = type.describeConstable().orElseThrow();
        return ClassFile.of()
                .build(
                        self,
                        builder ->
                                builder.withFlags(ClassFile.ACC_FINAL | ClassFile.ACC_SYNTHETIC)
                                        .withInterfaceSymbols(CODEC)
                                        .withMethodBody(
                                                INIT_NAME, MTD_void, 0, CodecGenerator::constructor)
                                        .withMethodBody(
                                                "write",
                                                MethodTypeDesc.of(
                                                        CD_void, RECORD, OBJECTS, CD_int, CD_int),
                                                ClassFile.ACC_PUBLIC,
                                                code -> write(code, record, fields))
                                        .withMethodBody(
                                                "read",
                                                MethodTypeDesc.of(RECORD, OBJECTS, CD_int, CD_int),
                                                ClassFile.ACC_PUBLIC,
                                                code -> read(code, record, fields)));
    }

    private static void constructor(CodeBuilder code) {
        code.aload(0).invokespecial(CD_Object, INIT_NAME, MTD_void).return_();
    }

    private static void write(CodeBuilder code, ClassDesc record, RecordComponent[] fields) {
        code.aload(VALUE).checkcast(record).astore(TYPED);
        for (int i = 0; i < fields.length; i++) {
            loadColumn(code, WRITE_COLUMNS, i, Kind.of(fields[i].getType()));
            code.aload(TYPED)
                    .invokevirtual(record, fields[i].getName(), MethodTypeDesc.of(desc(fields[i])));
            switch (Kind.of(fields[i].getType())) {
                case DOUBLE -> code.dastore();
                case FLOAT -> code.fastore();
                case LONG -> code.lastore();
                case INT -> code.iastore();
                case OBJECT -> code.aastore();
            }
        }
        code.return_();
    }

    private static void read(CodeBuilder code, ClassDesc record, RecordComponent[] fields) {
        ClassDesc[] parameters = new ClassDesc[fields.length];
        code.new_(record).dup();
        for (int i = 0; i < fields.length; i++) {
            parameters[i] = desc(fields[i]);
            loadColumn(code, READ_COLUMNS, i, Kind.of(fields[i].getType()));
            switch (Kind.of(fields[i].getType())) {
                case DOUBLE -> code.daload();
                case FLOAT -> code.faload();
                case LONG -> code.laload();
                case INT -> code.iaload();
                case OBJECT -> code.aaload().checkcast(parameters[i]);
            }
        }
        code.invokespecial(record, INIT_NAME, MethodTypeDesc.of(CD_void, parameters)).areturn();
    }

    /** Pushes {@code (type[]) columns[base + i]} and the row. */
    private static void loadColumn(CodeBuilder code, int columns, int i, Kind kind) {
        ClassDesc array =
                switch (kind) {
                    case DOUBLE -> CD_double.arrayType();
                    case FLOAT -> CD_float.arrayType();
                    case LONG -> CD_long.arrayType();
                    case INT -> CD_int.arrayType();
                    case OBJECT -> OBJECTS;
                };
        code.aload(columns).iload(columns + 1).loadConstant(i).iadd().aaload().checkcast(array);
        code.iload(columns + 2);
    }

    private static ClassDesc desc(RecordComponent field) {
        return field.getType().describeConstable().orElseThrow();
    }
}
