package net.sf.jaer.eventprocessing;

import java.beans.PropertyChangeEvent;
import java.beans.PropertyChangeSupport;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.logging.Logger;
import net.sf.jaer.chip.AEChip;

/** As much of the class of that name in jAER as the tests of the filter need. */
public abstract class EventFilter {
    public static final Logger log = Logger.getLogger("net.sf.jaer");
    /** What is kept from one filter to the next, as the preferences are. */
    public static final Map<String, String> PREFERENCES = new HashMap<>();

    protected AEChip chip;
    public final Map<String, String> tooltips = new HashMap<>();
    public final Set<String> hidden = new HashSet<>();
    private final PropertyChangeSupport support = new PropertyChangeSupport(this);
    private boolean enabled;

    public void setFilterEnabled(boolean yes) {
        enabled = yes;
    }

    public EventFilter(AEChip chip) {
        this.chip = chip;
    }

    public abstract void resetFilter();

    public abstract void initFilter();

    public boolean isFilterEnabled() {
        return enabled;
    }

    public PropertyChangeSupport getSupport() {
        return support;
    }

    protected void maybeAddListeners(AEChip chip) {
        
    }

    public void propertyChange(PropertyChangeEvent evt) {
        
    }

    public boolean isPreferenceStored(String key) {
        return PREFERENCES.containsKey(key);
    }

    public void putInt(String key, int value) {
        PREFERENCES.put(key, String.valueOf(value));
    }

    public void putFloat(String key, float value) {
        PREFERENCES.put(key, String.valueOf(value));
    }

    public void putBoolean(String key, boolean value) {
        PREFERENCES.put(key, String.valueOf(value));
    }

    public void putString(String key, String value) {
        PREFERENCES.put(key, String.valueOf(value));
    }

    public int getInt(String key, int def) {
        return PREFERENCES.containsKey(key) ? Integer.parseInt(PREFERENCES.get(key)) : def;
    }

    public float getFloat(String key, float def) {
        return PREFERENCES.containsKey(key) ? Float.parseFloat(PREFERENCES.get(key)) : def;
    }

    public boolean getBoolean(String key, boolean def) {
        return PREFERENCES.containsKey(key) ? Boolean.parseBoolean(PREFERENCES.get(key)) : def;
    }

    public String getString(String key, String def) {
        return PREFERENCES.containsKey(key) ? PREFERENCES.get(key) : def;
    }

    protected void hideProperty(String propertyName) {
        hidden.add(propertyName);
    }

    public final void setPropertyTooltip(String propertyName, String tooltip) {
        tooltips.put(propertyName, tooltip);
    }

    public final void setPropertyTooltip(String groupName, String propertyName, String tooltip) {
        tooltips.put(propertyName, tooltip);
    }
}
