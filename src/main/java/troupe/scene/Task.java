package troupe.scene;

/** Says what to plan. Each planner has one kind of task. */
public sealed interface Task extends Element permits Journey, Encounter, Crowd {

    /** Returns the seed from which every random stream of the task is derived. */
    long seed();

    @Override
    Task named(String otherId, String otherLabel);

    /** Returns the word for this kind in files: {@code journey}, {@code encounter}, … */
    String kind();
}
