package dev.cairn.core.ecs;

import static java.lang.constant.ConstantDescs.CD_Object;
import static java.lang.constant.ConstantDescs.CD_double;
import static java.lang.constant.ConstantDescs.CD_float;
import static java.lang.constant.ConstantDescs.CD_int;
import static java.lang.constant.ConstantDescs.CD_long;
import static java.lang.constant.ConstantDescs.CD_void;
import static java.lang.constant.ConstantDescs.INIT_NAME;
import static java.lang.constant.ConstantDescs.MTD_void;

import java.lang.classfile.ClassFile;
import java.lang.classfile.CodeBuilder;
import java.lang.constant.ClassDesc;
import java.lang.constant.MethodTypeDesc;
import java.lang.invoke.MethodHandles;
import java.lang.reflect.RecordComponent;

/**
 * Writes the class that moves one record type in and out of columns: straight-line code, one array
 * store per field, so that a spawn costs what hand-written code would. The class is hidden and a
 * nest mate of the record, so private nested records work as well.
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

    /** Generates the codec; the lookup must have full privilege access to the record's class. */
    static RecordCodec generate(MethodHandles.Lookup lookup, Class<?> type)
            throws ReflectiveOperationException {
        RecordComponent[] fields = type.getRecordComponents();
        ClassDesc record = type.describeConstable().orElseThrow();
        String simple = type.getName().substring(type.getPackageName().length());
        ClassDesc self =
                ClassDesc.of(
                        type.getPackageName(), simple.replace('.', ' ').strip() + "$$CairnCodec");
        byte[] bytes =
                ClassFile.of()
                        .build(
                                self,
                                builder ->
                                        builder.withFlags(
                                                        ClassFile.ACC_FINAL
                                                                | ClassFile.ACC_SYNTHETIC)
                                                .withInterfaceSymbols(CODEC)
                                                .withMethodBody(
                                                        INIT_NAME,
                                                        MTD_void,
                                                        0,
                                                        CodecGenerator::constructor)
                                                .withMethodBody(
                                                        "write",
                                                        MethodTypeDesc.of(
                                                                CD_void, RECORD, OBJECTS, CD_int,
                                                                CD_int),
                                                        ClassFile.ACC_PUBLIC,
                                                        code -> write(code, record, fields))
                                                .withMethodBody(
                                                        "read",
                                                        MethodTypeDesc.of(
                                                                RECORD, OBJECTS, CD_int, CD_int),
                                                        ClassFile.ACC_PUBLIC,
                                                        code -> read(code, record, fields)));
        MethodHandles.Lookup hidden =
                lookup.defineHiddenClass(bytes, true, MethodHandles.Lookup.ClassOption.NESTMATE);
        return (RecordCodec) hidden.lookupClass().getDeclaredConstructor().newInstance();
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
